// SPDX-License-Identifier: GPL-3.0-or-later
// The runs that the response surface is fitted to.

#include "diagnosis.H"

#include <algorithm>
#include <random>

Foam::List<Foam::misfit::vec>
Foam::misfit::diagnosis::parameterDesign() const
{
    List<vec> design(1, bounds_.mean);
    for (label i = 0; i < bounds_.nParameters; ++i)
    {
        for (const scalar side : {-1., 1.})
        {
            vec x = bounds_.mean;
            x[i] += 1.5*side*bounds_.deviation[i];
            x[i] = min(max(x[i], bounds_.lower[i]), bounds_.upper[i]);
            if (x[i] != bounds_.mean[i])
            {
                design.append(x);
            }
        }
    }
    return design;
}


Foam::List<Foam::misfit::vec> Foam::misfit::diagnosis::signatureDesign
(
    const vec& at,
    const labelList& mechanisms
) const
{
    List<vec> design;
    for (const label m : mechanisms)
    {
        for (const scalar s :
            {settings_.candidates[m].weak, settings_.candidates[m].strong})
        {
            design.append(at);
            design.last()[bounds_.nParameters + m] = s;
        }
    }
    return design;
}


Foam::List<Foam::misfit::vec> Foam::misfit::diagnosis::bankDesign() const
{
    std::mt19937 generator(settings_.seed);
    std::uniform_real_distribution<scalar> any;
    const label nP = bounds_.nParameters;
    const label nC = settings_.candidates.size();

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

    List<vec> design(1, bounds_.mean);
    while (design.size() < settings_.bank)
    {
        vec x = bounds_.mean;
        for (label i = 0; i < nP; ++i)
        {
            x[i] += (4*any(generator) - 2)*bounds_.deviation[i];
            x[i] = min(max(x[i], bounds_.lower[i]), bounds_.upper[i]);
        }
        for (label k = 0; nC && k < design.size() % 3; ++k)
        {
            const label c = take();
            x[nP + c] = any(generator)*bounds_.upper[nP + c];
        }
        design.append(x);
    }
    return design;
}
