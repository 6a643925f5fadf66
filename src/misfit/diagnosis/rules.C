// SPDX-License-Identifier: GPL-3.0-or-later
// The limits that a diagnosis decides by.

#include "rules.H"
#include "keywords.H"

#include "IFstream.H"
#include "OSspecific.H"

namespace
{

using namespace Foam;

//- As the project has them
dictionary standardRules()
{
    const fileName file
    (
        fileName("$INTERDEMFOAM_DIR/etc/misfit/rules").expand()
    );
    if (!isFile(file, false))
    {
        FatalErrorInFunction
            << "There is no " << file << ", which has the limits that a diagnosis"
            << " decides by: source etc/bashrc of interDEMFoam" << exit(FatalError);
    }
    IFstream is(file);
    dictionary all(is);
    all.remove("FoamFile");
    return all;
}


//- With what a case has otherwise
dictionary withChanges(const dictionary& decision)
{
    dictionary all(standardRules());
    keywords::checkRenamed
    (
        decision,
        {{"formulaTolerance", "modelDiscrepancy"}, {"tellingApart", "separation"}}
    );
    keywords::check(decision, all.toc());
    all.merge(decision);
    return all;
}

} // End anonymous namespace


Foam::misfit::rules::rules(const dictionary& decision)
:
    entries_(withChanges(decision))
{
    const auto isShare = [](const scalar x) { return x > 0 && x < 1; };
    const bool shares =
        isShare(significance) && isShare(adequacy) && isShare(matchedChance)
     && isShare(largestUncalibrated);
    if (!shares || refit < 1 || passes < 1 || temperature <= 0)
    {
        FatalIOErrorInFunction(decision)
            << "significance, adequacy, matchedChance and largestUncalibrated are"
            << " probabilities between 0 and 1, refit and passes 1 or more, the"
            << " temperature above zero"
            << exit(FatalIOError);
    }
}
