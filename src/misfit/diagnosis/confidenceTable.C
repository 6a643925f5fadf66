// SPDX-License-Identifier: GPL-3.0-or-later
// How often verdicts were right in cases whose cause was known: the table.

#include "confidenceTable.H"
#include "keywords.H"

#include "IFstream.H"
#include "OSspecific.H"

#include <iomanip>
#include <sstream>

const Foam::wordList Foam::misfit::groundNames
({
    "lead", "chance", "SNR", "gates", "confirmed", "more"
});


namespace
{

using namespace Foam;

const char* whatToDo = ". Make such a table with misfitConceal -calibrate";


//- Fatal unless it has these keywords and no others
void mustHave(const dictionary& dict, const wordList& keys)
{
    keywords::check(dict, keys, whatToDo);
    for (const word& key : keys)
    {
        if (!dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "There is no " << key << " in " << dict.name() << whatToDo
                << exit(FatalIOError);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::misfit::confidenceTable::row
Foam::misfit::confidenceTable::readRow(const dictionary& dict)
{
    wordList keys({"cases", "right", "constant"});
    keys.append(groundNames);
    mustHave(dict, keys);
    const label n = groundNames.size();
    row r;
    r.probability.constant = dict.get<scalar>("constant");
    r.probability.coefficients.resize(n);
    r.lower.resize(n);
    r.upper.resize(n);
    forAll(groundNames, i)
    {
        const vector three(dict.get<vector>(groundNames[i]));
        if (three.y() > three.z())
        {
            FatalIOErrorInFunction(dict)
                << groundNames[i] << " in " << dict.name() << " must be"
                << " (coefficient, least value, largest value)" << whatToDo
                << exit(FatalIOError);
        }
        r.probability.coefficients[i] = three.x();
        r.lower[i] = three.y();
        r.upper[i] = three.z();
    }
    return r;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::confidenceTable::confidenceTable(fileName file)
{
    file.expand();
    if (!isFile(file, false))
    {
        FatalErrorInFunction
            << "There is no table of confidences " << file
            << ". Name one with the keyword confidence of decision in misfitDict, or"
            << " leave that out for the one of the project; misfitConceal -calibrate"
            << " fits one" << exit(FatalError);
    }
    IFstream is(file);
    dictionary dict(is);
    dict.name() = file;
    dict.remove("FoamFile");
    const wordList verdicts(verdictNames.sortedToc());
    mustHave(dict, verdicts);
    for (const word& verdict : verdicts)
    {
        rows_.emplace(verdictNames[verdict], readRow(dict.subDict(verdict)));
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::scalar Foam::misfit::confidenceTable::operator()
(
    const verdictKind verdict,
    const groundValues& grounds
) const
{
    const row& r = rows_.at(verdict);
    return r.probability(grounds.cwiseMax(r.lower).cwiseMin(r.upper));
}
