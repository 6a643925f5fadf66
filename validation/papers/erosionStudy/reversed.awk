# SPDX-License-Identifier: GPL-3.0-or-later
# table.csv as if the paper's V were the void fraction: each number of the paper becomes
# that of the run with the same diameter and mass whose V is 1 - V.
#
#   awk -F, -f reversed.awk table.csv table.csv

function run(V) { return $3 " " $4 " " sprintf("%.4f", V) }

FNR == 1 {
    for (i = 1; i <= NF; i++) if ($i ~ /Paper$/) ofPaper[i]
    if (NR > FNR) print
    next
}

NR == FNR {
    for (i in ofPaper) paper[run($5), i] = $i
    next
}

{
    for (i in ofPaper) $i = paper[run(1 - $5), i]
    print
}
