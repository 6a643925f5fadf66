# SPDX-License-Identifier: GPL-3.0-or-later
# The paper's table. A number that follows from others is computed from them, U with D and
# M exchanged (see misprint.awk): Fr of Eq 12 and E of Eq 15 from its M, U and h. Its own
# Fr column and E with it, its U and Fr with that are kept as printed. Behind head.awk.

BEGIN {
    FS = ","
}

FNR == 1 {
    delete name
    for (i = 1; i <= NF; i++) name[i] = $i
    isPaper = $2 == "Fr"
    next
}

isPaper {
    runs[++nRuns] = $1
    for (i = 2; i <= NF; i++) paper[$1, name[i]] = $i
    split($1, part, /[DMV]/)
    D[$1] = part[2]/100; M[$1] = part[3]; V[$1] = part[4]/100
    printed[$1] = paper[$1, "Fr"]
    root = sqrt(g*paper[$1, "h"]*cosSlope)
    ours[$1, "UPrinted"] = paper[$1, "UPrinted"]
    ours[$1, "FrAsPrinted"] = sprintf("%.4g", paper[$1, "UPrinted"]/root)
    Fr = paper[$1, "U"]/root
    paper[$1, "Fr"] = Fr
    paper[$1, "E"] = M[$1]*g*paper[$1, "h"]*(1 + Fr*Fr/2)
    next
}
