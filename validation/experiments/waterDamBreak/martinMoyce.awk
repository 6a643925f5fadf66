# SPDX-License-Identifier: GPL-3.0-or-later
# A run beside the printed tables of Martin & Moyce (1952).
#
#   awk -v what=front|height -v column=.. [-v clock=0] \
#       -f martinMoyce.awk TABLE SERIES
#
# Prints a line for each row of TABLE: its time less "clock", its value, the value
# computed at that time, and by how much time the computed value is earlier at
# the same place. All as in TABLE: lengths over a (height over 2a), time over
# sqrt(a/2g) for the front and sqrt(a/g) for the height.

BEGIN {
    FS = "[ \t,]+"
    a = 0.05715
    g = 9.81
    unitTime = sqrt(a/(what == "front" ? 2*g : g))
    unitLength = what == "front" ? a : 2*a
}

!/^ *[-+0-9.]/ { next }

FNR == NR { T[++n] = $1 - clock; Z[n] = $2; next }

{ t[++m] = $1/unitTime; z[m] = $column/unitLength }

# y at place q of the series x, linear
function between(x, y, q,    i)
{
    for (i = 2; i <= m; ++i)
        if ((x[i] - q)*(x[i - 1] - q) <= 0 && x[i] != x[i - 1])
            return y[i - 1] + (y[i] - y[i - 1])*(q - x[i - 1])/(x[i] - x[i - 1])
    return "none"
}

END {
    for (i = 1; i <= n; ++i)
        print T[i], Z[i], between(t, z, T[i]), T[i] - between(z, t, Z[i])
}
