# SPDX-License-Identifier: GPL-3.0-or-later
# From tables grains.dat of sideView: time, place, depth and mean speed of the debris in
# strips along the bed [s, m, m, m/s]
#   -v width     of the slice [m]
#   -v strip     length of a strip [m]
#   -v fraction  solid fraction of the debris

function printStrips(    i)
{
    for (i in volume)
        print time, (i + 0.5)*strip, volume[i]/(fraction*width*strip), \
            weighted[i]/volume[i]
    delete volume
    delete weighted
}

FNR == 1 { printStrips(); n = split(FILENAME, part, "/"); time = part[n - 1] }
/^#/ || $1 < 0 { next }
{
    i = int($1/strip)
    V = $4^3*atan2(0, -1)/6
    volume[i] += V
    weighted[i] += V*$5
}
END { printStrips() }
