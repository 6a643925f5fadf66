#!/usr/bin/awk -f
# SPDX-License-Identifier: GPL-3.0-or-later
# Angle of repose [degrees] of a heap on a plate, both flanks and their mean; mean
# speed [m/s] and number of its grains:
#
#   slope.awk -v from=0.05 -v to=0.35 grains.dat
#
# from, to: where the plate begins and ends [m]. In each strip one grain wide the highest
# grain is a point of the surface. A line is fitted to each flank, from 15 to 85 % of half
# the plate.

/^#/ || $1 < from || $1 > to { next }

{
    d = $4
    speed += $5
    grains++
    strip = int(($1 - from)/d)
    if (!(strip in top) || $3 > top[strip]) top[strip] = $3
}

END {
    half = (to - from)/2
    for (strip in top)
    {
        x = (strip + 0.5)*d - half
        side = x < 0
        if (x < 0) x = -x
        if (x < 0.15*half || x > 0.85*half) continue
        n[side]++
        sx[side] += x
        sz[side] += top[strip]
        sxx[side] += x*x
        sxz[side] += x*top[strip]
    }
    for (side = 0; side < 2; ++side)
    {
        if (n[side] < 5) { print "none none none none", grains + 0; exit }
        slope = (n[side]*sxz[side] - sx[side]*sz[side])/(n[side]*sxx[side] - sx[side]^2)
        angle[side] = atan2(-slope, 1)*45/atan2(1, 1)
    }
    printf "%.2f %.2f %.2f %.4g %d\n", angle[1], angle[0], (angle[0] + angle[1])/2, \
        speed/grains, grains
}
