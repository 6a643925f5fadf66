// SPDX-License-Identifier: GPL-3.0-or-later
// Keywords and choices that have another name now.

#include "keywords.H"
#include "terminalOutput.H"

#include "IStringStream.H"

using namespace Foam;

namespace
{

dictionary entries(const std::string& text)
{
    return dictionary(IStringStream(text)());
}

} // End anonymous namespace


TEST(keywords, aFormerKeywordIsAnErrorThatNamesThePresentOne)
{
    const HashTable<word> renamed({{"old", "present"}});

    EXPECT_EQ
    (
        refusal([&]{ keywords::checkRenamed(entries("other 1;"), renamed); }),
        "nothing"
    );
    EXPECT_NE
    (
        refusal([&]{ keywords::checkRenamed(entries("old 1;"), renamed); })
       .find("Write present"),
        std::string::npos
    );
}


TEST(keywords, aFormerChoiceIsAnErrorThatNamesThePresentOne)
{
    const auto chosen = [](const std::string& text)
    {
        return refusal
        (
            [&]
            {
                keywords::choice
                (
                    entries(text), "model", "law", {"present"}, word::null,
                    {{"old", "present"}}
                );
            }
        );
    };

    EXPECT_EQ(chosen("model present;"), "nothing");
    EXPECT_NE(chosen("model old;").find("Write present"), std::string::npos);
    EXPECT_NE
    (
        chosen("model other;").find("Valid names: present"), std::string::npos
    );
}
