# SPDX-License-Identifier: GPL-3.0-or-later
# Surface of the mass of grains, from a table of sideView.
#
#   awk -v strip=.. -v width=.. -v fraction=.. -f profile.awk GRAINS
#
# Prints for each strip [m] its middle and the height that its grains would have
# at that solid fraction in a slab of that width.

!/^#/ {
    k = int($1/strip)
    volume[k] += 3.14159265358979/6*$4^3
    if (k > last) last = k
}

END {
    for (k = 0; k <= last; ++k)
        printf "%.6g %.6g\n", (k + 0.5)*strip, \
            volume[k]/(strip*width*fraction)
}
