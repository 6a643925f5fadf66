// SPDX-License-Identifier: GPL-3.0-or-later
// The runs that the response surface is fitted to.

#include "designs.H"

#include <algorithm>
#include <random>

std::vector<statistics::vec>
statistics::parameterDesign(const variableBounds& bounds)
{
    std::vector<vec> design(1, bounds.centre);
    for (int i = 0; i < bounds.nParameters; ++i)
    {
        for (const double side : {-1., 1.})
        {
            vec x = bounds.centre;
            x[i] += 1.5*side*bounds.width[i];
            x[i] = std::min(std::max(x[i], bounds.lower[i]), bounds.upper[i]);
            if (x[i] != bounds.centre[i])
            {
                design.push_back(x);
            }
        }
    }
    return design;
}


std::vector<statistics::vec> statistics::sensitivityDesign
(
    const variableBounds& bounds,
    const vec& at,
    const std::vector<int>& mechanisms,
    const std::vector<std::pair<double, double>>& strengths
)
{
    std::vector<vec> design;
    for (const int m : mechanisms)
    {
        for (const double strength : {strengths[m].first, strengths[m].second})
        {
            design.push_back(at);
            design.back()[bounds.nParameters + m] = strength;
        }
    }
    return design;
}


std::vector<statistics::vec> statistics::ensembleDesign
(
    const variableBounds& bounds,
    const int n,
    const unsigned seed
)
{
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> any;
    const int nP = bounds.nParameters;
    const int nC = bounds.nStrengths();

    // Each candidate as often as the others: drawn at random, one of six was in
    // none of 26 runs
    std::vector<int> order(inOrder(nC));
    int next = nC;
    const auto take = [&]()
    {
        if (next == nC)
        {
            std::shuffle(order.begin(), order.end(), generator);
            next = 0;
        }
        return order[next++];
    };

    std::vector<vec> design(1, bounds.centre);
    while (count(design) < n)
    {
        vec x = bounds.centre;
        for (int i = 0; i < nP; ++i)
        {
            x[i] += (4*any(generator) - 2)*bounds.width[i];
            x[i] = std::min(std::max(x[i], bounds.lower[i]), bounds.upper[i]);
        }
        for (int k = 0; nC && k < count(design) % 3; ++k)
        {
            const int c = take();
            x[nP + c] = any(generator)*bounds.upper[nP + c];
        }
        design.push_back(x);
    }
    return design;
}
