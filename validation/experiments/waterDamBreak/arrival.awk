# SPDX-License-Identifier: GPL-3.0-or-later
# When a column of a series first reaches a level, and its largest value.
#
#   awk [-v column=2] -v until=.. -v share=.. | -v level=.. -f arrival.awk FILE
#
# The level is given, or a share of the largest value up to the time "until".
# Prints the time, linear between lines, and the largest value of all.

BEGIN { FS = "[ \t,]+"; if (!column) column = 2 }

/^ *[-+0-9.]/ {
    sub(/^ +/, "")
    t[++n] = $1
    v[n] = $column
    if (n == 1 || v[n] > most) most = v[n]
    if (t[n] <= until && v[n] > first) first = v[n]
}

END {
    if (share) level = share*first
    for (i = 2; i <= n; ++i)
        if (v[i - 1] < level && v[i] >= level)
        {
            printf "%.6g %.6g\n", t[i - 1] + (t[i] - t[i - 1])* \
                (level - v[i - 1])/(v[i] - v[i - 1]), most
            exit
        }
    print "never", most
}
