// SPDX-License-Identifier: GPL-3.0-or-later
// A dictionary file, to change entries in it and leave the rest as it stands.

#include "fileDictionary.H"

#include "IFstream.H"
#include "IOobject.H"
#include "OStringStream.H"
#include "textFile.H"

namespace
{

//- While it lives, entries are kept as they stand
class asTheyStand
{
    const int old_ = Foam::entry::disableFunctionEntries;

public:

    asTheyStand()
    {
        Foam::entry::disableFunctionEntries = 1;
    }

    ~asTheyStand()
    {
        Foam::entry::disableFunctionEntries = old_;
    }
};

} // End anonymous namespace


Foam::misfit::fileDictionary::fileDictionary(const fileName& file)
:
    path(file)
{
    const asTheyStand keep;
    IFstream is(path);
    content.name() = path;
    content.read(is, true);
}


void Foam::misfit::fileDictionary::set(dictionary& where, Istream& entryText)
{
    const asTheyStand keep;
    const autoPtr<entry> e(entry::New(entryText));
    where.set(e->clone(where).ptr());
}


void Foam::misfit::fileDictionary::write() const
{
    // A copy may share the file by a link: it is replaced, never written into
    OStringStream os;
    os.precision(12);
    content.write(os, false);
    writeWhole(path, os.str());
}
