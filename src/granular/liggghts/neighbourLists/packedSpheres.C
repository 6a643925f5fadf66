// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres in single precision, to see quickly which ones cannot overlap.

#include "packedSpheres.H"

#include "boundsOf.H"

void Foam::packedSpheres::set
(
    const double* x,
    const double* radius,
    const int n
)
{
    const auto [low, high] = boundsOf(x, n);

    double extent = 0;
    for (int d = 0; n && d < 3; ++d)
    {
        extent = std::max(extent, high[d] - low[d]);
    }

    // Of the two centres each is off by half a unit in the last place along each
    // axis; the square of their distance and that of the reach by a few
    constexpr double unit = std::numeric_limits<float>::epsilon();
    const double margin = unit*extent;

    spheres_.resize(n);
    for (int i = 0; i < n; ++i)
    {
        spheres_[i] =
        {
            float(x[3*i] - low[0]),
            float(x[3*i + 1] - low[1]),
            float(x[3*i + 2] - low[2]),
            float(radius[i]*(1 + 4*unit) + margin)
        };
    }
}
