// SPDX-License-Identifier: GPL-3.0-or-later
// What the channels can see of an effect, with all that is uncertain.

#include "detectability.H"

#include <cmath>

Foam::misfit::detectability::detectability
(
    concealedSide& library,
    const fileName& caseFolder
)
:
    recorded_(withFiles(library.dict(), caseFolder), caseFolder),
    ask_(new predictedSampler(recorded_, library, library.trainingEnsemble("A")))
{
    const settings set(readSettings(library.dict()));
    beyond_ = set.beyond;
    visible_ = visible(*ask_, set);
}


Foam::misfit::vec
Foam::misfit::detectability::sampled(const nlohmann::json& effect) const
{
    vec all(data().size());
    for (const segment& s : data().segments)
    {
        const nlohmann::json& given = effect.at(s.name);
        series change;
        for (const scalar t : given["t"])
        {
            change.x.append(t);
        }
        for (const scalar y : given["change"])
        {
            change.y.append(y);
        }
        for (const channel& c : recorded_.channels())
        {
            if (c.name == s.name)
            {
                const scalarList values(c.sampled(change));
                s.of(all) =
                    Eigen::Map<const vec>(values.cdata(), values.size());
            }
        }
    }
    return all;
}


Foam::scalar Foam::misfit::detectability::noiseSNR(const vec& effect) const
{
    return whitener(visible_.sensors)(effect).norm();
}


Foam::misfit::detectableEffect
Foam::misfit::detectability::operator()(const vec& effect) const
{
    detectableEffect found;
    found.noiseSNR = noiseSNR(effect);
    found.SNR = whitener(visible_.calibrated)(effect).norm();

    // The parameters take up what they can within their priors
    const vec left = visible_.all*visible_.calibrated.ldlt().solve(effect);
    found.places = statistics::stretches(data(), left, visible_.all, beyond_);
    return found;
}
