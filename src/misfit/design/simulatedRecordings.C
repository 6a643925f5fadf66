// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of an experiment that nobody has done.

#include "simulatedRecordings.H"
#include "stages.H"

#include <random>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

wordList namesOf(const stacked& data)
{
    wordList names;
    for (const segment& s : data.segments)
    {
        names.append(word(s.name, false));
    }
    return names;
}


//- What a diagnosis knows of the experiment before its recordings: surface and covariance
void addRuns(study& s)
{
    addUncertainty(s);
    addCalibrationRuns(s);
    if (s.set.trainingEnsemble || s.simulation.trainingEnsemble().size())
    {
        return;
    }
    const std::vector<int> every(statistics::inOrder(s.names.size()));
    s.addRuns(s.sensitivityDesign(s.bounds.mean, every));
    s.build();
}

} // End anonymous namespace


Foam::misfit::simulatedRecordings::simulatedRecordings
(
    sampler& simulation,
    const settings& set,
    const label repeats
)
:
    all_(simulation.data().first(), repeats),
    whole_(simulation, all_, all_.data().y, namesOf(all_.data()), false),
    study_(whole_, set)
{
    addRuns(study_);
}


Foam::misfit::vec Foam::misfit::simulatedRecordings::operator()
(
    const label mechanism,
    const scalar strength,
    const label draw
) const
{
    const variableBounds& bounds = study_.bounds;
    std::seed_seq seeds{label(study_.set.seed), draw + 1, label(53)};
    std::mt19937 generator(seeds);
    std::normal_distribution<scalar> normal;

    hypothesisFit truth;
    vec x = bounds.mean;
    for (label i = 0; i < bounds.nParameters; ++i)
    {
        const scalar drawn = bounds.mean[i] + bounds.deviation[i]*normal(generator);
        x[i] = min(max(drawn, bounds.lower[i]), bounds.upper[i]);
    }
    truth.fit.x = x.head(bounds.nParameters);
    if (mechanism >= 0)
    {
        x[bounds.nParameters + mechanism] = strength;
        truth.what.mechanisms = {int(mechanism)};
        truth.fit.x.conservativeResize(bounds.nParameters + 1);
        truth.fit.x[bounds.nParameters] = strength;
    }

    // Nature's formula is another one
    const sampledModel& m = study_.calibration;
    const vec f = m.surface()(x);
    const whitener white(m.uncertainty().at(f) + m.score().modelDiscrepancy(truth));
    vec independent(f.size());
    for (scalar& value : independent)
    {
        value = normal(generator);
    }
    return f + white.colour(independent);
}
