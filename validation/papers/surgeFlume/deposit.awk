# SPDX-License-Identifier: GPL-3.0-or-later
# Depth of a deposit from grains.dat of sideView: twice the mean height of the
# grains' volume over each 0.1 m of the base is the depth of a layer that is the
# same all through. Prints the greatest depth and the mean one over the length
# that holds 90 % of the volume.
#
#   awk -f deposit.awk grains.dat

/^#/ { next }

{
    strip = int($1/0.1)
    volume[strip] += $4^3
    moment[strip] += $4^3*$3
    all += $4^3
    if (strip > last) last = strip
}

END {
    for (s = 0; s <= last; s++)
    {
        passed += volume[s]
        if (passed < 0.05*all || passed - volume[s] > 0.95*all) continue
        depth = volume[s] > 0 ? 2*moment[s]/volume[s] : 0
        sum += depth
        n++
        if (depth > most) most = depth
    }
    printf "%.3g %.3g\n", most, n ? sum/n : 0
}
