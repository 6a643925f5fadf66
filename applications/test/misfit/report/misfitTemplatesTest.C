// SPDX-License-Identifier: GPL-3.0-or-later
// Templates of etc/misfit that somebody has changed, and has changed wrongly.

#include "templates.H"
#include "terminalOutput.H"
#include "temporaryFolder.H"
#include "textFile.H"

#include "OSspecific.H"

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- What comes of a template page.html with that text, or the error
std::string pageFrom(const std::string& text)
{
    const temporaryFolder scratch;
    const fileName folder(scratch);
    mkDir(folder/"etc/misfit");
    writeWhole(folder/"etc/misfit/page.html", text);

    const string before(getEnv("INTERDEMFOAM_DIR"));
    setEnv("INTERDEMFOAM_DIR", folder, true);
    std::string page;
    const std::string output
    (
        refusal([&]() { page = fillTemplate("page.html", {{"a", "it"}, {"b", true}}); })
    );
    setEnv("INTERDEMFOAM_DIR", before, true);
    return output == "nothing" ? page : output;
}

} // End anonymous namespace


TEST(misfitTemplates, oneThatIsRightIsFilled)
{
    EXPECT_EQ(pageFrom("{{#b}}say\n {{a}}{{/b}}"), "say\n it");
}


TEST(misfitTemplates, oneWithAFaultIsRefusedByFileAndLine)
{
    for
    (
        const char* wrong :
        {"one\ntwo {{#b}}say {{a}}\n", "one\ntwo {{/b}}\n", "one\ntwo {{a\n"}
    )
    {
        const std::string output(pageFrom(wrong));
        expectHolds(output, "etc/misfit/page.html");
        expectHolds(output, "Line 2 of");
        expectHolds(output, "Correct it");
    }
}
