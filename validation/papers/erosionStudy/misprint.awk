# SPDX-License-Identifier: GPL-3.0-or-later
# Does Eq 12 give the Fr of a run from its U and h, as printed and with the labels of one
# column rearranged? From what misfitTable has tried:
#
#   awk -F, -f misprint.awk tableA1.tried.csv
#
# Prints lines "check,quantity,value,reference,unit" for statistics.csv.

function writeRow(check, quantity, value, reference, unit)
{
    printf "%s,the paper's table - %s,%s,%s,%s\n", check, quantity, value, reference, unit
}

function writeMatch(which)
{
    writeRow("reported", "mean difference; U " which, sprintf("%.3g", 100*$5), "", "%")
    writeRow("reported", "runs that it gives as far as digits are printed; U " which, $3)
}

$1 == "none" {
    writeRow("within", "runs that it misses by more; U as printed", 27 - $4, "18 0")
    writeMatch("as printed")
}

# The best of each column first, by the runs that it gives as far as digits are printed
$2 != "labels" { next }

$1 == "U" && !nOfU++ {
    writeRow("atLeast", "runs whose Fr Eq 12 gives within 1.1 %; U corrected", $4, 27)
    writeMatch("corrected")
    writeRow("atMost", "chance that one of all exchanges tried does so", $6, 1e-6)
    next
}

!($1 in hasRow) {
    hasRow[$1]
    writeRow("atMost", "runs within 1.1 % with the other arrangement of the labels of " $1 \
        " that gives most as far as digits are printed", $4, 20)
    writeRow("reported", "runs that this arrangement gives as far as digits are printed; " $1, $3)
}
