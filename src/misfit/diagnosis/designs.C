// SPDX-License-Identifier: GPL-3.0-or-later
// The runs that the response surface is fitted to.

#include "designs.H"

#include <algorithm>
#include <random>

std::vector<Foam::misfit::vec>
Foam::misfit::parameterDesign(const study& s)
{
    std::vector<vec> design(1, s.bounds().mean);
    for (label i = 0; i < s.bounds().nParameters; ++i)
    {
        for (const scalar side : {-1., 1.})
        {
            vec x = s.bounds().mean;
            x[i] += 1.5*side*s.bounds().deviation[i];
            x[i] = min(max(x[i], s.bounds().lower[i]), s.bounds().upper[i]);
            if (x[i] != s.bounds().mean[i])
            {
                design.push_back(x);
            }
        }
    }
    return design;
}


std::vector<Foam::misfit::vec> Foam::misfit::sensitivityDesign
(
    const study& s,
    const vec& at,
    const std::vector<int>& mechanisms
)
{
    std::vector<vec> design;
    for (const int m : mechanisms)
    {
        const candidate& c = s.set().candidates[m];
        for (const scalar strength : {c.weak, c.strong})
        {
            design.push_back(at);
            design.back()[s.bounds().nParameters + m] = strength;
        }
    }
    return design;
}


std::vector<Foam::misfit::vec> Foam::misfit::ensembleDesign(const study& s)
{
    std::mt19937 generator(s.set().seed);
    std::uniform_real_distribution<scalar> any;
    const label nP = s.bounds().nParameters;
    const label nC = s.set().candidates.size();

    // Each candidate as often as the others: drawn at random, one of six was in
    // none of 26 runs
    labelList order(identity(nC));
    label next = nC;
    const auto take = [&]()
    {
        if (next == nC)
        {
            std::shuffle(order.begin(), order.end(), generator);
            next = 0;
        }
        return order[next++];
    };

    std::vector<vec> design(1, s.bounds().mean);
    while (count(design) < s.set().trainingEnsemble)
    {
        vec x = s.bounds().mean;
        for (label i = 0; i < nP; ++i)
        {
            x[i] += (4*any(generator) - 2)*s.bounds().deviation[i];
            x[i] = min(max(x[i], s.bounds().lower[i]), s.bounds().upper[i]);
        }
        for (label k = 0; nC && k < count(design) % 3; ++k)
        {
            const label c = take();
            x[nP + c] = any(generator)*s.bounds().upper[nP + c];
        }
        design.push_back(x);
    }
    return design;
}
