# SPDX-License-Identifier: GPL-3.0-or-later
# The tables of a run's function objects, of all its starts: the number at a time, the
# last line. Before row.awk, which makes a row of them.

# .../<object>/<start>/<table>.dat: a run that was stopped has tables of several
# starts, in any order. Where a start wrote no state before it was killed, the next
# one is at the same time, and its table is <table>_<start>.dat: a little later here
FNR == 1 {
    n = split(FILENAME, part, "/")
    table = part[n]
    sub(/\.dat$/, "", table)
    again = sub(/_[0-9.]+(e[-+]?[0-9]+)?$/, "", table)
    table = part[n - 2] " " table
    tableOf[++file] = table
    began[file] = part[n - 1] + (again ? 1e-9 : 0)
}

/^#/ {
    nColumns = NF - 1
    for (i = 1; i <= nColumns; i++) name[i] = $(i + 1)
    if (name[1] == "Time")
        for (i = 1; i <= nColumns; i++) place[table, name[i]] = i
    next
}

# Profiles are not needed; a line that a kill has cut short is none
name[1] != "Time" || NF < nColumns { next }

# At equal times the later start wins
{
    reached[file] = $1 + 0
    if (!((table, $1) in from)) times[table, ++nTimes[table]] = $1
    else if (began[from[table, $1]] > began[file]) next
    from[table, $1] = file
    text[table, $1] = $0
}

# False if a later start went over this time again, in steps of its own
function counts(table, t,    f)
{
    for (f in tableOf)
        if (tableOf[f] == table && began[f] > began[from[table, t]] \
            && began[f] < t + 0 && reached[f] >= t + 0) return 0
    return 1
}

# Number in the line of a time; "" where there is none
function cell(table, t, column,    c)
{
    if (!((table, t) in text) || !((table, column) in place)) return ""
    split(text[table, t], c, " ")
    return c[place[table, column]] + 0
}

function lastTime(table,    k, t, latest)
{
    latest = ""
    for (k = 1; k <= nTimes[table]; k++)
    {
        t = times[table, k]
        if ((latest == "" || t + 0 > latest + 0) && counts(table, t)) latest = t
    }
    return latest
}

# Number in the last line of a table
function last(table, column)
{
    return cell(table, lastTime(table), column)
}
