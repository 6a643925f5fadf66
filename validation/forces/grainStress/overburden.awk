# SPDX-License-Identifier: GPL-3.0-or-later
# Mean of the weight above, per area [Pa], over slabs and spheres: from the
# heights of the grains (x y z in each line).
#
#   awk -v weight=0.0136 -v area=0.0144 -v slabs="0 0.04 0.08" \
#       -v spheres="0.07 0.03" -f overburden.awk
#
# weight: that of a grain [N]; area: of the column [m2]; slabs: their borders;
# spheres: height of the centre and radius [m].

BEGIN { n = split(slabs, border, " "); split(spheres, s, " ") }

# Share of the slab, or of the sphere, that lies below the grain's centre
{
    for (k = 1; k < n; ++k)
        slab[k] += within(($3 - border[k])/(border[k + 1] - border[k]), 0)

    t = within(($3 - s[1])/s[2], -1)
    sphere += (2 + 3*t - t^3)/4
}

function within(x, least)
{
    return x < least ? least : x > 1 ? 1 : x
}

END {
    for (k = 1; k < n; ++k) printf "%.6g ", slab[k]*weight/area
    printf "%.6g %.6g\n", sphere*weight/area, NR*weight/area
}
