# SPDX-License-Identifier: GPL-3.0-or-later
# Means over time of a record of OpenFOAM's probes.
#
#   awk -v width=.. -f pressure.awk RECORD
#
# Prints for each period of that width [s] its middle and the mean of all probes.

function printMean()
{
    if (n) printf "%g %.5g\n", (k + 0.5)*width, s/n
    n = s = 0
}

/^ *[0-9]/ {
    now = int($1/width)
    if (now != k) { printMean(); k = now }
    for (i = 2; i <= NF; ++i) { s += $i; ++n }
}

END { printMean() }
