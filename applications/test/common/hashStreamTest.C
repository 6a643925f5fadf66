// SPDX-License-Identifier: GPL-3.0-or-later
// Hashes of dictionaries, which each function object has OpenFOAM make.

#include "hashStream.H"

#include "OSstream.H"
#include "SHA1Digest.H"
#include "dictionary.H"
#include "primitiveEntry.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

//- Writes itself as one character, as a newer C++ library writes brackets
class characterEntry
:
    public primitiveEntry
{
    static bool good_;

    const char c_;

public:

    explicit characterEntry(const char c)
    :
        primitiveEntry("c", label(0)),
        c_(c)
    {}

    virtual autoPtr<entry> clone(const dictionary&) const
    {
        return autoPtr<entry>(new characterEntry(c_));
    }

    virtual void write(Ostream& os) const
    {
        good_ = dynamic_cast<OSstream&>(os).stdStream().put(c_).good();
    }

    //- False where a stream did not take the last one
    static bool good()
    {
        return good_;
    }
};

bool characterEntry::good_ = false;


//- As libOpenFOAM makes it
SHA1Digest digestOf(const char c)
{
    dictionary dict;
    dict.add(new characterEntry(c));

    return dict.digest();
}

} // End anonymous namespace


TEST(hashStream, ofTheLibraryTakesSingleCharacters)
{
    EXPECT_TRUE(hashStreamTakesCharacters());

    const SHA1Digest a(digestOf('a'));
    EXPECT_TRUE(characterEntry::good());
    EXPECT_NE(a.str(), digestOf('b').str());
}
