# SPDX-License-Identifier: GPL-3.0-or-later
# Judges the result.csv of one case against the known deviations:
#
#   awk -v name=CASE -v number=N -v tally=FILE -f judge.awk shorts.csv result.csv
#
# Prints a line for each row, numbered on from N where it counts as a test, and
# appends "passed", "failed ...", "skipped ..." or "short ..." to the tally.

function abs(x) { return x < 0 ? -x : x }

function count(verdict, text)
{
    printf "%5d  %-8s %s: %s\n", ++number, verdict, name, text
    print verdict, name ":", text >> tally
}

# A known short may miss its bound by a tenth more than what is listed
function judgeShort(q, text,    bound, listed)
{
    bound = $3
    sub(/^[<>]= /, "", bound)
    listed = value[q]
    if (abs($2 - bound) > 1.1*abs(listed - bound))
        count("failed", text "; worse than the " listed " of shorts.csv")
    else
        count("short", text "; " cause[q])
}

BEGIN { FS = "," }

FNR == NR {
    if (FNR > 1 && $1 == name)
    {
        value[$2] = $3
        cause[$2] = $0
        sub(/^[^,]*,[^,]*,[^,]*,/, "", cause[$2])
    }
    next
}

$1 == "skipped" { count("skipped", $2); skipped = 1; exit }

FNR == 1 && $1 == "quantity" { next }

# Its first row would be taken for the names of the columns
FNR == 1 { count("failed", "its result.csv has lost the names of the columns") }

{
    rows++
    seen[$1] = 1
    text = $1 " = " $2 ($5 == "" ? "" : " " $5)
    if ($3 != "") text = text "; wanted " $3 ($4 == "" ? "" : " +- " $4)
}

# A number without a bound must be there all the same
$6 == "reported" && $2 ~ /^(none|-?nan|-?inf)?$/ { count("failed", text); next }

$6 == "reported" {
    printf "%5s  %-8s %s: %s\n", "", "", name, text
    next
}

$6 == "pass" && ($1 in value) {
    count("failed", text "; no longer short, take it out of shorts.csv")
    next
}

$6 == "pass" { count("passed", text); next }

$6 == "short" && ($1 in value) { judgeShort($1, text); next }

{ count("failed", text) }

END {
    if (skipped) exit
    if (!rows) count("failed", "its result.csv holds no row")
    # A person may run a part of a case
    if (ENVIRON["INTERDEMFOAM_ALLTEST"] == "") exit
    # What only the whole of a case measures is required only where the whole was run
    for (q in value)
        if (!(q in seen) && !(q ~ /^whole: / && ENVIRON["INTERDEMFOAM_ALLTEST"] == "quick"))
            count("failed", q " is in shorts.csv but is not measured")
}
