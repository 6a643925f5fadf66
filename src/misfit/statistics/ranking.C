// SPDX-License-Identifier: GPL-3.0-or-later
// Possible explanations of a misfit, all of them fitted, in the order of their scores.

#include "hypothesis.H"

#include <cmath>

namespace
{

using namespace statistics;

//- Explanations with mechanisms [-] that are fitted once more with something unknown
//  beside them: the best, since each costs one more fit and a worse one cannot win
constexpr int mostBesideUnknown = 4;

//- Largest lag in score [-2 ln(likelihood)] behind the best at which an explanation gets
//  a covariance of its own: at 30 its probability is exp(-15) of the best's
constexpr double largestLag = 30;

//- Explanations [-] of those that get one, at most: each costs a fit and a factorisation
//  of the covariance, and a small misfit leaves all within the lag
constexpr int mostOwnCovariances = 12;

//- The sort that the number of hypotheses counts in
int sortOf(const hypothesis& h)
{
    return h.fault ? 3 : h.unknown ? 4 : h.mechanisms.size();
}


//- Adds twice the logarithm of the number of hypotheses of its sort
void addNumbers(std::vector<hypothesisFit>& list)
{
    std::vector<int> number(5, 0);
    for (const hypothesisFit& w : list)
    {
        ++number[sortOf(w.what)];
    }
    for (hypothesisFit& w : list)
    {
        w.number = 2*std::log(double(number[sortOf(w.what)]));
        w.score += w.number;
    }
}

} // End anonymous namespace


void statistics::scoring::addPartly(std::vector<hypothesisFit>& list) const
{
    std::vector<hypothesisFit> partly;
    for (const hypothesisFit& w : list)
    {
        if (w.what.mechanisms.size() && count(partly) < mostBesideUnknown)
        {
            partly.push_back(scoreUnknown(w));
        }
    }
    for (const hypothesisFit& w : list)
    {
        if (w.what.fault && w.what.fault->kind == faultKind::swapped)
        {
            partly.push_back(scoreUnknown(withOwnCovariance(w)));
            break;
        }
    }
    list.insert(list.end(), partly.begin(), partly.end());
}


std::vector<statistics::hypothesisFit> statistics::scoring::all
(
    const std::vector<int>& mechanisms,
    const std::vector<sensorFault>& faults,
    const bool pairs
) const
{
    // The others start from the base with its own covariance
    const hypothesisFit none(base());
    const whitener white(none.covariance);

    std::vector<hypothesisFit> list;
    list.push_back(withBaseCovariance(hypothesis(), white));
    for (int i = 0; i < count(mechanisms); ++i)
    {
        hypothesis h;
        h.mechanisms = {mechanisms[i]};
        list.push_back(withBaseCovariance(h, white));
        for (int j = i + 1; pairs && j < count(mechanisms); ++j)
        {
            h.mechanisms = {mechanisms[i], mechanisms[j]};
            list.push_back(withBaseCovariance(h, white));
        }
    }
    for (const sensorFault& fault : faults)
    {
        hypothesis h;
        h.fault = fault;
        hypothesisFit w
        (
            (fault.noiseScales(data_).array() == 1).all()
          ? withBaseCovariance(h, white)
          : withBaseCovariance(h, whitener(inUnitOf(fault, none.covariance)))
        );
        if (h.movesRecord())
        {
            w = withBaseCovariance(h, whitener(ownCovariance(w, w.fit.f)));
        }
        list.push_back(w);
    }
    list.push_back(scoreUnknown(none));
    addNumbers(list);
    sortByScore(list);

    // The best, the base and each mechanism alone, with their own covariance
    const double limit = list.front().score + largestLag;
    int withOwn = 0;
    for (hypothesisFit& w : list)
    {
        if (w.what.unknown)
        {
            continue;
        }
        const bool single = w.what.mechanisms.size() == 1;
        const bool leads = w.score < limit && withOwn++ < mostOwnCovariances;
        if (leads || single || w.what.isNone())
        {
            w = withOwnCovariance(w);
        }
        else
        {
            w.covariance = none.covariance;
        }
    }
    sortByScore(list);
    addPartly(list);
    sortByScore(list);
    return list;
}


void statistics::setProbabilities
(
    std::vector<hypothesisFit>& list,
    const double temperature
)
{
    double least = large;
    for (const hypothesisFit& w : list)
    {
        least = std::min(least, w.score);
    }
    double sum = 0;
    for (hypothesisFit& w : list)
    {
        w.probability =
            std::exp(-std::min(0.5*(w.score - least)/temperature, 700.0));
        sum += w.probability;
    }
    for (hypothesisFit& w : list)
    {
        w.probability /= sum;
    }
}
