// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the column of a published table whose numbers stand at the wrong rows.

#include "tableFiles.H"
#include "tableWords.H"

#include "argList.H"
#include "IFstream.H"
#include "fpeGuard.H"
#include "serialTool.H"

#include <fstream>
#include <stdexcept>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- Fatal if it cannot be written
template<class Write>
void writeFile(const fileName& file, const Write& write)
{
    std::ofstream os(file);
    write(os);
    os.close();
    if (!os)
    {
        FatalErrorInFunction << "Cannot write " << file << exit(FatalError);
    }
    Info<< "Written: " << file << nl;
}


void run(const dictionary& dict)
{
    const tableCheck check(dict);
    Info<< report(check).c_str();

    const fileName stem(check.file().nameLessExt());
    writeFile
    (
        stem + ".verdict.json",
        [&](std::ostream& os) { writeJson(check, os); }
    );
    writeFile
    (
        stem + ".tried.csv",
        [&](std::ostream& os) { writeTried(check, os); }
    );
    if
    (
        check.verdict() == tableVerdict::registration
     && check.best().size() == 1
     && check.columnIsMoved(check.tried().front())
    )
    {
        writeFile
        (
            stem + ".corrected.csv",
            [&](std::ostream& os)
            {
                writeCorrected(check, check.tried().front(), os);
            }
        );
    }
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
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

    IFstream is(args[1]);
    if (!is.good())
    {
        FatalErrorInFunction << "Cannot read " << args[1] << exit(FatalError);
    }
    const dictionary dict(is);

    // A formula without a value is told by its line
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
