// SPDX-License-Identifier: GPL-3.0-or-later
// Draws what concealed cases hide, and the noise of their readings.

#include "caseDrawing.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::misfit::caseDrawing::uniform(const scalar from, const scalar to)
{
    return from + (to - from)*any_(generator_);
}


Foam::label Foam::misfit::caseDrawing::pick(const label n)
{
    return min(label(n*any_(generator_)), n - 1);
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::caseDrawing::caseDrawing(const concealedSide& truth, const label seed)
:
    generator_(seed),
    seed_(seed),
    parameters_(readParameters(truth.dict().subDict("parameters"))),
    outside_(truth.outside())
{
    for (const channel& c : truth.bare().channels())
    {
        if (c.experiment == "A" && c.use == purpose::calibration)
        {
            channels_.append(c.name);
        }
    }
    for (const candidate& c : readCandidates(truth.dict().subDict("candidates")))
    {
        candidates_.insert(c.name, c);
        if (!outside_.found(c.name))
        {
            library_.append(c.name);
        }
    }
    if (library_.size() < 2 || outside_.empty() || channels_.empty())
    {
        FatalIOErrorInFunction(truth.dict())
            << "The truth needs two candidates of the library, one that the entry"
            << " outside names, and a channel to fit" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::misfit::json Foam::misfit::caseDrawing::draw()
{
    const scalar lot = any_(generator_);
    nlohmann::json parameters = nlohmann::json::object();
    for (const parameter& p : parameters_)
    {
        // As far as an ensemble reaches
        const scalar z = min(max(normal_(generator_), -2.0), 2.0);
        const scalar x = p.mean + p.deviation*z;
        parameters[p.name] = min(max(x, p.lower), p.upper);
    }
    const scalar jitter = 0.005*normal_(generator_);
    const word kind
    (
        lot < 0.3 ? "null" : lot < 0.55 ? "single" : lot < 0.67 ? "pair"
      : lot < 0.82 ? "outside" : "sensor"
    );
    json key =
    {
        {"kind", kind}, {"noise", pick(2) ? 2.0 : 1.0},
        {"mechanisms", json::array()}, {"parameters", parameters},
        {"startOff", jitter}, {"faulty", ""}, {"fault", ""}, {"faultSize", 0.0}
    };
    if (kind == "sensor")
    {
        key["faulty"] = channels_[pick(channels_.size())];
        const word fault(wordList({"gain", "zero", "lag", "drift", "clock"})[pick(5)]);
        const scalar side = pick(2) ? 1 : -1;
        key["fault"] = fault;
        key["faultSize"] =
            fault == "gain" ? side*uniform(0.1, 0.3)
          : fault == "lag" ? uniform(0.03, 0.12)
          : fault == "clock" ? side*uniform(0.03, 0.1)
          : side*uniform(0.05, 0.2);
    }
    wordList names;
    if (kind != "null" && kind != "sensor")
    {
        const wordList& from = kind == "outside" ? outside_ : library_;
        const label n = from.size();
        const label i = pick(n);
        names.append(from[i]);
        if (kind == "pair")
        {
            names.append(from[(i + 1 + pick(n - 1)) % n]);
        }
    }
    for (const word& name : names)
    {
        const candidate& c = candidates_[name];
        key["mechanisms"].push_back
        (
            {{"name", name}, {"strength", uniform(c.weak, c.strong)}}
        );
    }
    return key;
}


Foam::misfit::json Foam::misfit::caseDrawing::measured
(
    const json& parameters,
    const label number
) const
{
    // Apart from all else that is drawn, and whichever cases are made
    std::seed_seq own{seed_, number};
    std::mt19937 generator(own);
    json all = json::object();
    for (const parameter& p : parameters_)
    {
        if (p.isMeasured)
        {
            std::normal_distribution<scalar> error(0, p.measuredDeviation);
            const scalar x = parameters.at(p.name).get<scalar>() + error(generator);
            all[p.name] = min(max(x, p.lower), p.upper);
        }
    }
    return all;
}


void Foam::misfit::caseDrawing::addNoise
(
    series& s,
    const scalar deviation,
    const scalar step
)
{
    scalar slow = normal_(generator_);
    const scalar keep = std::exp(-step/0.02);
    for (scalar& y : s.y)
    {
        slow = keep*slow + Foam::sqrt(1 - keep*keep)*normal_(generator_);
        y +=
            deviation
           *(Foam::sqrt(0.8)*normal_(generator_) + Foam::sqrt(0.2)*slow);
    }
}
