# SPDX-License-Identifier: GPL-3.0-or-later
# Whether the table of a page has the numbers of the tables of scores:
#
#   awk -f tables.awk score.A.csv score.B.csv page.md
#
# for a page whose table has the columns: score, goal, one for each of those files, and
# any others. With -v goals=no goals are the page's own. Prints each cell that differs,
# then the number of cells that were compared.
BEGIN {
    FS = ","
    csv["nulls: not none"] = "nulls with another verdict than none [%]"
    csv["single: right name"] = "single: right name where SNR >= 5 [%]"
    csv["pair: both named"] = "pair: both named where SNR >= 5 [%]"
    csv["a given name is right"] = "a name that is given is right [%]"
    csv["outside: unknown"] = "outside the library: unknown where SNR >= 5 [%]"
    csv["outside: wrongly named"] = "outside the library: wrongly named [%]"
    csv["fault blamed on physics"] = "sensor fault blamed on physics [%]"
    csv["physics blamed on a sensor"] = "physics blamed on a sensor [%]"
    csv["where: F1"] = "where: overlap F1"
    csv["size off by, %"] = "size of the effect at the probes off by [%]"
    csv["removed, test channels, %"] = "misfit removed at test channels [%]"
    csv["removed in C, %"] = "misfit removed in experiment C [%]"
    csv["Brier score"] = "Brier score of the confidence"
}

function trimmed(text)
{
    gsub(/^ +| +$/, "", text)
    return text
}

# The number as it is printed, to its last digit; a share by what it is of
function isThat(cell, value, cases,    parts, digits)
{
    if (split(cell, parts, "/") == 2)
        return parts[2] == cases && (100*parts[1]/parts[2] - value)^2 < 1e-4
    digits = index(cell, ".") ? length(cell) - index(cell, ".") : 0
    return cell != "" && (cell - value)^2 <= (0.5000001*10^-digits)^2
}

function wrong(cell, expected)
{
    print FILENAME ": " name " has " cell " where the table has " expected
}

/^score,/ { files++; next }

FILENAME ~ /csv$/ {
    value[$1, files] = $2
    cases[$1, files] = $5
    goal[$1] = $6
    next
}

/^\|/ {
    n = split($0, cell, "|")
    name = cell[2]
    gsub(/`| *\(SNR .*\)/, "", name)
    name = trimmed(name)
    if (!(name in csv)) next
    bound = cell[3]
    gsub(/≤/, "<=", bound)
    gsub(/≥/, ">=", bound)
    sub(/ *%/, "", bound)
    if (goals != "no") {
        compared++
        if (trimmed(bound) != goal[csv[name]])
            wrong("the goal " trimmed(bound), "\"" goal[csv[name]] "\"")
    }
    for (i = 1; i <= files; i++)
    {
        # Behind the number may be its interval
        split(trimmed(cell[3 + i]), number, " ")
        compared++
        if (!isThat(number[1], value[csv[name], i], cases[csv[name], i]))
            wrong(number[1], value[csv[name], i] " of " cases[csv[name], i])
    }
}

END { print compared + 0, "cells" }
