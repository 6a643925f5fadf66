// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the column of a published table whose numbers stand at the wrong rows.

#include "tableCheck.H"
#include "textFile.H"

#include "fpeGuard.H"
#include "OSspecific.H"
#include "projectVersion.H"
#include "serialTool.H"

#include <stdexcept>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

void write(const fileName& file, const std::string& text)
{
    writeWhole(file, text);
    Info<< "Written: " << file << nl;
}


void run(const dictionary& dict)
{
    const tableCheck check(dict);
    Info<< report(check).c_str();

    // One of an earlier table must not lie beside the verdict on this one
    const fileName stem(check.file.nameLessExt());
    rm(stem + ".corrected.csv");
    write(stem + ".verdict.json", tableJson(check));
    write(stem + ".tried.csv", triedTable(check));
    if
    (
        check.verdict == verdictKind::registration
     && check.best.size() == 1
     && check.best.front().isOfColumn()
    )
    {
        write
        (
            stem + ".corrected.csv",
            correctedTable(check, check.best.front().fault)
        );
    }
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Find the column of a table whose numbers stand at the wrong rows, by an"
        " identity that all rows must hold. See README.md beside the source."
    );
    argList::noBanner();
    argList::noParallel();
    argList::addArgument("dictionary");
    startSerialTool();
    const argList args(argc, argv);
    const dictionary dict(readArgument(args));

    // The error for a formula without a value names its line
    const fpeGuard guard;
    try
    {
        run(dict);
    }
    catch (const std::logic_error& wrong)
    {
        FatalErrorInFunction
            << "Table " << dict.get<fileName>("table") << ": " << wrong.what()
            << exit(FatalError);
    }
    Info<< endl;
    return 0;
}
