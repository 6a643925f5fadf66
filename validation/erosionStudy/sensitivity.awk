# SPDX-License-Identifier: GPL-3.0-or-later
# What else but the three numbers moves the answers: for each run with one thing
# varied the difference to the same run without, in %.
#
#   awk -v suffix=-slice -f sensitivity.awk rows...

BEGIN {
    FS = ","
    nColumns = split("U h H L Lc Ue Fc E", column, " ")
}

FNR == 1 {
    for (i = 1; i <= NF; i++) name[i] = $i
    next
}

{
    order[++n] = $1
    for (i = 1; i <= NF; i++) value[$1, name[i]] = $i
}

END {
    printf "run,varied,ranks"
    for (c = 1; c <= nColumns; c++)
        printf ",%s,%sDifference", column[c], column[c]
    print ""

    for (r = 1; r <= n; r++)
    {
        match(order[r], "^[^-]*" suffix)
        base = substr(order[r], 1, RLENGTH)
        varied = substr(order[r], RLENGTH + 2)
        if (varied == "") varied = "nothing"
        printf "%s,%s,%s", base, varied, value[order[r], "ranks"]
        for (c = 1; c <= nColumns; c++)
        {
            v = value[order[r], column[c]]
            v0 = value[base, column[c]]
            printf ",%.4g,%s", v, v0 ? sprintf("%.1f", 100*(v/v0 - 1)) : ""
        }
        print ""
    }
}
