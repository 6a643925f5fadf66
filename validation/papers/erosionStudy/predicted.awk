# SPDX-License-Identifier: GPL-3.0-or-later
# What the surfaces of procedure.md predicted for the runs that judge, beside what came:
#
#   awk -f predicted.awk design/calibrateDict.csv judged.csv
#
# Lines for statistics.csv, of the runs that are done.

BEGIN {
    FS = ","
    nQuantities = split("H L Lc", quantity, " ")
}

# predicted,chute,D 0.04 M 115 V 0.45,H,,value,error
NR == FNR {
    if ($1 != "predicted") next
    split($3, at, " ")
    run = sprintf("D%.0fM%dV%.0f", 100*at[2], at[4], 100*at[6])
    value[run, $4] = $6
    error[run, $4] = $7
    next
}

FNR == 1 {
    for (i = 1; i <= NF; i++) c[$i] = i
    next
}

$2 == "done" {
    n++
    for (i = 1; i <= nQuantities; i++)
    {
        q = quantity[i]
        off = $c[q] - value[$1, q]
        if (off < 0) off = -off
        sum[q] += off/value[$1, q]
        near[q] += off <= 2*error[$1, q]
    }
}

END {
    for (i = 1; n && i <= nQuantities; i++)
    {
        q = quantity[i]
        printf "reported,%s - mean absolute difference to what the surface predicted,%.3g,,%%\n", \
            q, 100*sum[q]/n
        printf "reported,%s - within twice the error of the surface,%d of %d,,\n", q, near[q], n
    }
}
