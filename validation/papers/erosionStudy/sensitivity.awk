# SPDX-License-Identifier: GPL-3.0-or-later
# What else but the three numbers moves the answers: for each run with one thing
# varied the difference to the same run without, in %; none of a number that one of the
# two does not have, or has read elsewhere along the chute.
#
#   awk -v suffix=-slice -f head.awk -f sensitivity.awk rows...

BEGIN {
    FS = ","
    nColumns = split("U h H L Lc Ue Umoving Fc E", column, " ")
    ofHead["U"]; ofHead["h"]; ofHead["E"]
}

FNR == 1 {
    for (i = 1; i <= NF; i++) name[i] = $i
    next
}

{
    order[++n] = $1
    readRow($1, 1)
}

# In % of the run without the variation
function difference(run, base, q,    v, v0)
{
    v = ours[run, q]
    v0 = ours[base, q]
    if (q in ofHead && whereRead(run) != whereRead(base)) return ""
    return v != "" && v0 ? sprintf("%.1f", 100*(v/v0 - 1)) : ""
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
        printf "%s,%s,%s", base, varied, ours[order[r], "ranks"]
        for (c = 1; c <= nColumns; c++)
        {
            v = ours[order[r], column[c]]
            printf ",%s,%s", v == "" ? "" : sprintf("%.4g", v), \
                difference(order[r], base, column[c])
        }
        print ""
    }
}
