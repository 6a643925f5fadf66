// SPDX-License-Identifier: GPL-3.0-or-later
// What all stages of a diagnosis share: who answers, what decides, and which
// variables there are.

#include "study.H"
#include "designs.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Of the parameters, with room for so many strengths after them
variableBounds boundsOf(const List<parameter>& parameters, const label strengths)
{
    variableBounds b;
    const label n = parameters.size() + strengths;
    b.nParameters = parameters.size();
    b.mean = b.deviation = b.lower = b.upper = b.centre = b.width = vec::Zero(n);
    forAll(parameters, i)
    {
        const parameter& p = parameters[i];
        b.mean[i] = p.measured;
        b.deviation[i] = p.measuredDeviation;
        b.centre[i] = p.mean;
        b.width[i] = p.deviation;
        b.lower[i] = p.lower;
        b.upper[i] = p.upper;
    }
    return b;
}


variableBounds withCandidates(const settings& set)
{
    variableBounds b(boundsOf(set.parameters, set.candidates.size()));
    forAll(set.candidates, i)
    {
        b.upper[b.nParameters + i] = set.candidates[i].upper;
        b.width[b.nParameters + i] = set.candidates[i].strong;
    }
    return b;
}


variableBounds withElements(const settings& set)
{
    variableBounds b(boundsOf(set.parameters, set.correction.size()));
    forAll(set.correction, i)
    {
        const label k = b.nParameters + i;
        const scalar size = set.correction[i].size;
        b.width[k] = b.deviation[k] = size;
        b.lower[k] = -4*size;
        b.upper[k] = 4*size;
    }
    return b;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::study::study(sampler& s, const settings& set)
:
    simulation(s),
    set(set),
    names(namesOfAll(set.candidates)),
    bounds(withCandidates(set)),
    experiments(s.data()),
    calibration
    (
        data().calibration, bounds, set.clockUncertainty, set.modelDiscrepancy,
        set.chaotic
    ),
    validation
    (
        data().validation, bounds, set.clockUncertainty, set.modelDiscrepancy, set.chaotic
    )
{}


Foam::misfit::study Foam::misfit::study::ofCorrection() const
{
    study other(*this);
    other.names = namesOfAll(set.correction);
    other.bounds = withElements(set);
    other.calibration.setVariables(other.bounds);
    other.validation.setVariables(other.bounds);
    other.nRuns = 0;
    return other;
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::wordList
Foam::misfit::study::namesOf(const std::vector<int>& strengths) const
{
    wordList some;
    for (const int k : strengths)
    {
        some.append(names[k]);
    }
    return some;
}


std::vector<Foam::misfit::vec> Foam::misfit::study::sensitivityDesign
(
    const vec& around,
    const std::vector<int>& strengths
) const
{
    std::vector<std::pair<scalar, scalar>> both;
    for (const candidate& c : set.candidates)
    {
        both.push_back({c.weak, c.strong});
    }
    return statistics::sensitivityDesign(bounds, around, strengths, both);
}


Foam::List<Foam::misfit::samples>
Foam::misfit::study::means(const List<runState>& states)
{
    nRuns += states.size()*set.commonRandomNumbers;
    return simulation.means(states, set.commonRandomNumbers);
}


Foam::List<Foam::misfit::samples>
Foam::misfit::study::means(const std::vector<vec>& variables)
{
    List<runState> states;
    for (const vec& x : variables)
    {
        states.append(state(x));
    }
    return means(states);
}


void Foam::misfit::study::leaveOut(const runState& s, const string& why)
{
    failed.append({s, why});
    Info<< "    left out: " << describe(s).c_str() << ": " << why.c_str() << endl;
}


Foam::List<Foam::misfit::samples>
Foam::misfit::study::addRuns(const std::vector<vec>& variables)
{
    const List<samples> results(means(variables));
    forAll(results, i)
    {
        if (results[i].ok())
        {
            calibration.addRun(variables[i], results[i].calibration);
            validation.addRun(variables[i], results[i].validation);
        }
    }
    return results;
}
