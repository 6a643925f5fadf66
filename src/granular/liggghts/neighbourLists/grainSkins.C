// SPDX-License-Identifier: GPL-3.0-or-later
// How far each grain may move before its neighbours are sought again.

#include "grainSkins.H"

#include "boundsOf.H"

#include <cmath>
#include <numeric>

void Foam::grainSkins::chooseCells
(
    const double* x,
    const double* radius,
    const int n
)
{
    const auto [low, high] = boundsOf(x, n);
    low_ = low;
    const double sum = std::accumulate(radius, radius + n, 0.0);

    // As wide as a grain, and wider where there were more cells than grains
    side_ = 2*sum/n;
    double all;
    do
    {
        all = 1;
        for (int d = 0; d < 3; ++d)
        {
            const double cells = std::floor((high[d] - low_[d])/side_) + 1;
            cells_[d] = int(std::min(cells, n + 1.0));
            all *= cells;
        }
        side_ *= all > n ? wideningOfCells : 1;
    } while (all > n);

    fastest_.assign(std::size_t(all), 0);
}


template<class Function>
void Foam::grainSkins::cellsAround
(
    const double* x,
    const double r,
    const Function& f
) const
{
    std::array<int, 3> first, last;
    for (int d = 0; d < 3; ++d)
    {
        const double most = cells_[d] - 1;
        const auto cell = [&](const double at)
        {
            return int(std::max(0.0, std::min(most, (at - low_[d])/side_)));
        };
        first[d] = cell(x[d] - r);
        last[d] = cell(x[d] + r);
    }

    for (int z = first[2]; z <= last[2]; ++z)
    {
        for (int y = first[1]; y <= last[1]; ++y)
        {
            for (int k = first[0]; k <= last[0]; ++k)
            {
                f((z*cells_[1] + y)*cells_[0] + k);
            }
        }
    }
}


void Foam::grainSkins::find
(
    const double* x,
    const double* v,
    const double* radius,
    const int n,
    const double time,
    const double least,
    const double most,
    std::vector<double>& skins
)
{
    skins.resize(n);
    if (!n)
    {
        return;
    }

    chooseCells(x, radius, n);

    for (int i = 0; i < n; ++i)
    {
        const float speed =
            float(std::sqrt(v[3*i]*v[3*i] + v[3*i + 1]*v[3*i + 1]
            + v[3*i + 2]*v[3*i + 2]));

        // What is slow has the least skin anyway
        if (speed*time > least)
        {
            cellsAround
            (
                x + 3*i,
                radius[i] + std::min(speed*time, most),
                [&](const int c) { fastest_[c] = std::max(fastest_[c], speed); }
            );
        }
    }

    for (int i = 0; i < n; ++i)
    {
        float speed = 0;
        cellsAround
        (
            x + 3*i,
            radius[i],
            [&](const int c) { speed = std::max(speed, fastest_[c]); }
        );
        skins[i] = std::min(most, std::max(least, speed*time));
    }
}
