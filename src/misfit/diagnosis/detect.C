// SPDX-License-Identifier: GPL-3.0-or-later
// Calibration, and whether, where and when recording and simulation still part.

#include "stages.H"
#include "designs.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Numbers of the candidates that were on in some runs, and in none that ended
std::vector<int> alwaysFailing
(
    const study& s,
    const std::vector<vec>& design,
    const List<samples>& results
)
{
    std::vector<int> failing;
    forAll(s.names, m)
    {
        label nAttempts = 0;
        label ran = 0;
        for (label i = 0; i < count(design); ++i)
        {
            const bool on = design[i][s.bounds.nParameters + m] > 0;
            nAttempts += on;
            ran += on && results[i].ok();
        }
        if (nAttempts && !ran)
        {
            failing.push_back(m);
        }
    }
    return failing;
}


//- What candidates, as far as they were run, and sensor faults would change in the
//  fitted samples: a column for each
mat shapes(const study& s, const hypothesisFit& base)
{
    const sampledModel& calibration = s.calibration;
    mat changes(calibration.size(), 0);
    const auto add = [&changes](const vec& change)
    {
        if (change.norm() > SMALL)
        {
            appendColumn(changes, change);
        }
    };

    const vec at = calibration.model(base.what).expand(base.fit.x);
    // A weak effect may look otherwise than a strong one, as one that delays
    for (const vec& with : s.sensitivityDesign(at, statistics::inOrder(s.names.size())))
    {
        add(calibration.surface()(with) - calibration.surface()(at));
    }
    for (const sensorFault& fault : possibleFaults(calibration.data(), s.set.faults))
    {
        if (fault.size() == 1)
        {
            add(fault(calibration.data(), base.fit.f, fault.slight) - base.fit.f);
        }
    }
    return changes;
}


std::vector<place> placesOf
(
    const std::vector<window>& windows,
    const stacked& data,
    const vec& misfit
)
{
    std::vector<place> places;
    for (const window& w : windows)
    {
        const label first = data.segments[w.segment].first + w.begin;
        places.push_back
        ({
            w, misfit.segment(first, w.end - w.begin).mean()
        });
    }
    return places;
}


//- Where and when recording and calibrated base part beyond chance; left: chance of that
std::vector<place> locate
(
    const study& s,
    const hypothesisFit& base,
    const scanResult& left
)
{
    const stacked& data = s.calibration.data();
    const vec misfit = data.y - base.fit.f;
    std::vector<window> clear;
    if (left.p < s.set.significance)
    {
        clear =
            statistics::stretches(data, misfit, base.covariance, s.set.beyond);
        if (clear.empty())
        {
            // More than chance, yet no sample is far off: the strongest window
            clear = left.windows;
            clear.resize(min(clear.size(), size_t(1)));
        }
    }
    return placesOf(clear, data, misfit);
}


List<calibratedParameter> parametersOf(const settings& set, const hypothesisFit& base)
{
    List<calibratedParameter> all;
    forAll(set.parameters, i)
    {
        const parameter& p = set.parameters[i];
        all.append
        ({
            p.name, p.measured, p.measuredDeviation, base.fit.x[i],
            base.fit.deviation(i), base.fit.pinned[i]
        });
    }
    return all;
}

} // End anonymous namespace


std::vector<int> Foam::misfit::addCalibrationRuns(study& s)
{
    Info<< "Calibration" << endl;
    std::vector<vec> design
    (
        s.set.trainingEnsemble
      ? ensembleDesign(s.bounds, s.set.trainingEnsemble, s.set.seed)
      : parameterDesign(s.bounds)
    );
    if (s.simulation.trainingEnsemble().size())
    {
        design.clear();
        for (const runState& state : s.simulation.trainingEnsemble())
        {
            design.push_back(variablesOf(s.set.parameters, s.names, state));
        }
    }
    const List<samples> results(s.addRuns(design));
    forAll(results, i)
    {
        if (!results[i].ok())
        {
            s.leaveOut(s.state(design[i]), results[i].failure);
        }
    }
    s.build();
    return alwaysFailing(s, design, results);
}


Foam::misfit::scanResult Foam::misfit::scanResidual
(
    const study& s,
    const hypothesisFit& w,
    const mat& shapes
)
{
    const sampledModel& m = s.calibration;
    const hypothesisModel model(m.model(w.what));
    const mat slopes = model.slopes(w.fit.x);
    const vec deviation = model.deviation();
    const vec fromMean = deviation.unaryExpr
    (
        [](const scalar d) { return d > 0 ? 1.0 : 0.0; }
    ).cwiseProduct(w.fit.x - model.mean());
    const whitener white
    (
        statistics::withFitted(w.covariance, slopes, deviation)
    );
    const statistics::scan scan
    (
        m.data(), white, s.set.draws, s.set.seed, shapes
    );
    return scan
    (
        m.data().y - w.fit.f + slopes*fromMean,
        s.set.significance
    );
}


Foam::misfit::misfitDetection Foam::misfit::detect
(
    const study& s,
    const hypothesisFit& base
)
{
    Info<< "Detection" << endl;
    const settings& set = s.set;
    const stacked& data = s.calibration.data();
    const vec atMean = s.calibration.surface()(s.bounds.mean);
    const whitener white(s.calibration.uncertainty().at(atMean));
    const statistics::scan raw(data, white, set.draws, set.seed);
    const scanResult left(scanResidual(s, base, shapes(s, base)));
    return
    {
        raw(data.y - atMean, set.significance),
        left,
        locate(s, base, left),
        parametersOf(set, base),
        data,
        base.covariance.diagonal().cwiseSqrt(),
        s.calibration.uncertainty().sources(base.fit.f),
        base.covariance
    };
}


std::vector<Foam::misfit::place> Foam::misfit::locateNamed
(
    const study& s,
    const stageResults& e,
    const decision& d
)
{
    // What is left counts, too: nature's formula may be another one
    const stacked& data = s.calibration.data();
    const scalar share = s.set.residualShare;
    const vec explained =
        (1 - share)*(d.after - d.before) + share*(data.y - d.before);
    return placesOf
    (
        statistics::stretches
        (
            data,
            explained,
            e.explained.baseline().covariance,
            s.set.beyond
        ),
        data,
        explained
    );
}


Foam::misfit::screenedCandidates Foam::misfit::addSensitivityRuns
(
    study& s,
    const hypothesisFit& base,
    const screenedCandidates& candidates
)
{
    if (s.set.trainingEnsemble || s.simulation.trainingEnsemble().size())
    {
        return candidates;
    }
    Info<< "Sensitivities of the mechanisms" << endl;
    vec at = s.bounds.mean;
    at.head(s.bounds.nParameters) =
        base.fit.x.head(s.bounds.nParameters);
    std::vector<vec> design(1, at);
    const std::vector<vec> alone(s.sensitivityDesign(at, candidates.left));
    design.insert(design.end(), alone.begin(), alone.end());
    const List<samples> results(s.addRuns(design));

    screenedCandidates result{{}, candidates.dropped, candidates.failing};
    for (label i = 0; i < count(candidates.left); ++i)
    {
        const int mechanism = candidates.left[i];
        const samples& weak = results[1 + 2*i];
        if (weak.ok() || results[2 + 2*i].ok())
        {
            result.left.push_back(mechanism);
        }
        else
        {
            result.failing.push_back(mechanism);
            result.dropped.append
            ({
                s.names[mechanism], droppedCandidate::reason::failed,
                weak.failure, 0, 0
            });
        }
    }
    s.build();
    return result;
}
