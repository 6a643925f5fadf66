// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates that cannot be the cause, before a run is spent on them.

#include "stages.H"

const Foam::Enum<Foam::misfit::droppedCandidate::reason> Foam::misfit::dropReasonNames
({
    {droppedCandidate::reason::failedAlways, "failedAlways"},
    {droppedCandidate::reason::failed, "failed"},
    {droppedCandidate::reason::opposite, "opposite"},
    {droppedCandidate::reason::small, "small"}
});


namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- True if a feature that the candidate is expected to change differs the other way,
//  and none as expected
bool isOpposite
(
    const rules& limits,
    const candidate& c,
    const stacked& data,
    const std::vector<vec>& changes
)
{
    bool asExpected = false;
    bool opposite = false;
    for (const expectedSign& e : c.signs)
    {
        const label f = featureNames.find(e.feature);
        for (label k = 0; k < count(data.segments) && f >= 0; ++k)
        {
            if (data.segments[k].quantity == e.quantity)
            {
                const scalar change = e.sign*changes[k][f];
                asExpected = asExpected || change > limits.oppositeSign;
                opposite = opposite || change < -limits.oppositeSign;
            }
        }
    }
    return opposite && !asExpected;
}

} // End anonymous namespace


Foam::misfit::screenedCandidates Foam::misfit::screen
(
    const study& s,
    const hypothesisFit& base,
    const std::vector<int>& failing
)
{
    Info<< "Screening of the candidates" << endl;
    const stacked& data = s.calibration.data();
    const whitener white(base.covariance);
    const vec sigma = base.covariance.diagonal().cwiseSqrt();
    std::vector<vec> changes;
    scalar largest = 0;
    for (const segment& at : data.segments)
    {
        changes.push_back
        (
            statistics::changeOfFeatures(at, base.fit.f, data.y, white)
        );
        largest = max
        (
            largest,
            statistics::shareBeyond
            (
                at, at.of(data.y), at.of(base.fit.f), at.of(sigma)
            )
        );
    }

    using reason = droppedCandidate::reason;
    screenedCandidates result;
    result.failing = failing;
    forAll(s.set.candidates, i)
    {
        const candidate& c = s.set.candidates[i];
        const auto drop = [&](const reason why)
        {
            result.dropped.append({c.name, why, "", c.bound, largest});
        };
        if (statistics::contains(failing, int(i)))
        {
            drop(reason::failedAlways);
        }
        else if (isOpposite(s.set, c, data, changes))
        {
            drop(reason::opposite);
        }
        else if (largest > s.set.aboveBound*c.bound)
        {
            drop(reason::small);
        }
        else
        {
            result.left.push_back(i);
        }
    }
    return result;
}
