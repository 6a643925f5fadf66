# SPDX-License-Identifier: GPL-3.0-or-later
# Rms difference of two profiles, x and height by commas or blanks, as % of a height. The
# first is linear between its lines, and 0 beyond the last:
#
#   awk -v height=0.048 -f ../../tools/profileDifference.awk COMPUTED MEASURED

BEGIN { FS = "[ ,]" }

!/^[0-9]/ { next }

FNR == NR { x[++n] = $1; h[n] = $2; next }

{
    for (i = 2; i < n && x[i] < $1; ++i) ;
    y = h[i - 1] + (h[i] - h[i - 1])*($1 - x[i - 1])/(x[i] - x[i - 1])
    if ($1 > x[n]) y = 0
    s += (y - $2)^2
    ++m
}

END { printf "%.3g", 100*sqrt(s/m)/height }
