// SPDX-License-Identifier: GPL-3.0-or-later
// What all stages of a diagnosis share: who answers, what decides, and which
// variables there are.

#include "study.H"
#include "designs.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::study::setVariables(const wordList& strengths)
{
    names = strengths;
    const label nP = set.parameters.size();
    const label n = nP + strengths.size();
    bounds.nParameters = nP;
    bounds.mean = bounds.deviation = vec::Zero(n);
    bounds.lower = bounds.upper = width = vec::Zero(n);
    for (label i = 0; i < nP; ++i)
    {
        const parameter& p = set.parameters[i];
        bounds.mean[i] = p.mean;
        width[i] = bounds.deviation[i] = p.deviation;
        bounds.lower[i] = p.lower;
        bounds.upper[i] = p.upper;
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::study::study(sampler& s, const settings& set)
:
    ask(s),
    set(set),
    experiments(s.data())
{
    setVariables(namesOfAll(set.candidates));
    forAll(set.candidates, i)
    {
        bounds.upper[bounds.nParameters + i] = set.candidates[i].upper;
        width[bounds.nParameters + i] = set.candidates[i].strong;
    }
    const auto model = [&](const stacked& recorded)
    {
        return std::make_unique<sampledModel>(recorded, bounds, set.clockUncertainty);
    };
    calibration = model(data().calibration);
    validation = model(data().validation);
}


Foam::misfit::study Foam::misfit::study::ofCorrection() const
{
    study other(ask, set);
    other.setVariables(namesOfAll(set.correction));
    forAll(set.correction, i)
    {
        const label k = bounds.nParameters + i;
        const scalar size = set.correction[i].size;
        other.width[k] = other.bounds.deviation[k] = size;
        other.bounds.lower[k] = -4*size;
        other.bounds.upper[k] = 4*size;
    }
    other.calibration = calibration->withVariables(other.bounds);
    other.validation = validation->withVariables(other.bounds);
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
    return ask.means(states, set.commonRandomNumbers);
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
    const List<samples> given(means(variables));
    forAll(given, i)
    {
        if (given[i].ok())
        {
            calibration->addRun(variables[i], given[i].calibration);
            validation->addRun(variables[i], given[i].validation);
        }
    }
    return given;
}
