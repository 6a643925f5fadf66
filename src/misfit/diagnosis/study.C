// SPDX-License-Identifier: GPL-3.0-or-later
// What all stages of a diagnosis share: who answers, what decides, and which
// variables there are.

#include "study.H"
#include "designs.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::study::setVariables(const wordList& names)
{
    names_ = names;
    const label nP = settings_.parameters.size();
    const label n = nP + names.size();
    bounds_.nParameters = nP;
    bounds_.mean = bounds_.deviation = vec::Zero(n);
    bounds_.lower = bounds_.upper = width_ = vec::Zero(n);
    for (label i = 0; i < nP; ++i)
    {
        const parameter& p = settings_.parameters[i];
        bounds_.mean[i] = p.mean;
        width_[i] = bounds_.deviation[i] = p.deviation;
        bounds_.lower[i] = p.lower;
        bounds_.upper[i] = p.upper;
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::study::study(sampler& s, const settings& set)
:
    sampler_(s),
    settings_(set)
{
    wordList names;
    for (const candidate& c : set.candidates)
    {
        names.append(c.name);
    }
    setVariables(names);
    forAll(set.candidates, i)
    {
        bounds_.upper[bounds_.nParameters + i] = set.candidates[i].upper;
        width_[bounds_.nParameters + i] = set.candidates[i].strong;
    }
}


Foam::misfit::study Foam::misfit::study::ofCorrection() const
{
    study other(*this);
    wordList names;
    for (const correctionElement& e : settings_.correction)
    {
        names.append(e.name);
    }
    other.setVariables(names);
    forAll(settings_.correction, i)
    {
        const label k = bounds_.nParameters + i;
        const scalar size = settings_.correction[i].size;
        other.width_[k] = other.bounds_.deviation[k] = size;
        other.bounds_.lower[k] = -4*size;
        other.bounds_.upper[k] = 4*size;
    }
    other.nRuns_ = 0;
    return other;
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::wordList
Foam::misfit::study::namesOf(const std::vector<int>& strengths) const
{
    wordList names;
    for (const int k : strengths)
    {
        names.append(names_[k]);
    }
    return names;
}


std::vector<Foam::misfit::vec> Foam::misfit::study::sensitivityDesign
(
    const vec& around,
    const std::vector<int>& strengths
) const
{
    std::vector<std::pair<scalar, scalar>> both;
    for (const candidate& c : settings_.candidates)
    {
        both.push_back({c.weak, c.strong});
    }
    return statistics::sensitivityDesign(bounds_, around, strengths, both);
}


Foam::misfit::runState
Foam::misfit::study::state(const vec& variables) const
{
    return state(data().experiment, variables);
}


Foam::misfit::runState Foam::misfit::study::state
(
    const word& experiment,
    const vec& variables
) const
{
    return stateOf(settings_, experiment, names_, variables);
}


Foam::misfit::vec Foam::misfit::study::variables(const runState& s) const
{
    vec x = bounds_.mean;
    forAll(settings_.parameters, i)
    {
        x[i] = s.parameters.lookup(settings_.parameters[i].name, x[i]);
    }
    forAll(names_, i)
    {
        x[bounds_.nParameters + i] = s.strengths.lookup(names_[i], 0);
    }
    return x;
}


Foam::List<Foam::misfit::samples>
Foam::misfit::study::run(const List<runState>& states)
{
    nRuns_ += states.size();
    return sampler_(states);
}


Foam::List<Foam::misfit::samples>
Foam::misfit::study::means(const List<runState>& states)
{
    nRuns_ += states.size()*settings_.commonRandomNumbers;
    return sampler_.means(states, settings_.commonRandomNumbers);
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
    failed_.append({s, why});
    Info<< "    left out: " << describe(s).c_str() << ": " << why.c_str() << endl;
}


Foam::misfit::models::models(const study& s)
:
    calibration
    (
        new sampledModel
        (
            s.data().calibration, s.bounds(), s.set().clockUncertainty
        )
    ),
    validation
    (
        new sampledModel(s.data().validation, s.bounds(), s.set().clockUncertainty)
    )
{}


Foam::List<Foam::misfit::samples>
Foam::misfit::models::addRuns(study& s, const std::vector<vec>& variables)
{
    const List<samples> given(s.means(variables));
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
