# SPDX-License-Identifier: GPL-3.0-or-later
# The misprint in the paper's table, from the table alone: does Eq 12 give the Fr of a
# run from its U and h, as printed, and with the labels of one column arranged anew?
#
#   awk -F, -f arrangements.awk -f misprint.awk paper.csv
#
# Tells lines "check,quantity,value,wanted,unit" for statistics.csv.

function tell(check, quantity, value, wanted, unit)
{
    printf "%s,the paper's table - %s,%s,%s,%s\n", check, quantity, value, wanted, unit
}

NR == 1 {
    for (i = 1; i <= NF; i++) c[$i] = i
    next
}

{
    split($1, label, /[DMV]/)
    cell = label[2] - 1
    cell = cell (label[3] - 80)/35 (label[4] - 40)/5
    Fr[cell] = $c["Fr"]; U[cell] = $c["UPrinted"]; H[cell] = $c["h"]
    corrected[cell] = $c["U"]
}

END {
    for (cell in U)
        same += corrected[cell] == U[substr(cell, 2, 1) substr(cell, 1, 1) substr(cell, 3)]
    tell("atLeast", "runs whose corrected U is the printed one with D and M exchanged", \
        same, 27)

    try("U", exchange, 1, 1, 1)
    tell("atLeast", "runs whose Fr Eq 12 gives within 1.1 %; U corrected", within, 27)
    tell("reported", "mean difference; U corrected", sprintf("%.2g", off), "", "%")
    tell("reported", "runs that it gives as far as digits are printed; U corrected", rounded)
    try("U", "123", 1, 1, 1)
    tell("within", "runs that it misses by more; U as printed", 27 - within, "18 0")
    tell("reported", "mean difference; U as printed", sprintf("%.3g", off), "", "%")
    tell("reported", "runs that it gives as far as digits are printed; U as printed", \
        rounded)

    n = split("U h Fr", column, " ")
    for (i = 1; i <= n; i++)
    {
        q = column[i]
        tryAll(q)
        tell("atMost", "most runs within 1.1 % of " tried[q] \
            " other arrangements of the labels of " q, most[q], 26)
        tell("reported", "their least mean difference; " q, sprintf("%.2g", least[q]), "", "%")
        tell("reported", "the most as far as digits are printed; " q, mostRounded[q])
    }
}
