# SPDX-License-Identifier: GPL-3.0-or-later
# The row of a run from the tables of its function objects: the last line of
# each, and means of the layers over the net erosion. Tells what is wrong where a
# number is not there or the run has not come to its end.
#
#   awk -v run= -v hash= -v code= -v ranks= -v seconds= -v endTime= [-v pressure=] \
#       -f row.awk tables...
#
# Of the bare flume, whose name begins with flume, it is another row: pressure is then
# what surgeFlume/probe.awk tells.

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

function put(heading, v)
{
    if (v == "")
    {
        print "its tables have no " heading
        exit 1
    }
    head = head (head == "" ? "" : ",") heading
    row = row (row == "" ? "" : ",") v
}

function putLast(table, columns,    n, i, column)
{
    n = split(columns, column, " ")
    for (i = 1; i <= n; i++) put(column[i], last(table, column[i]))
}

# Mean of a column of the layers over the net erosion; that of a velocity is over
# what moves, with its thickness, since a layer without grains has none
function overErosion(column, thickness,    k, t, w, sum, weights)
{
    for (k = 1; k <= nTimes["bed layers"]; k++)
    {
        t = times["bed layers", k]
        if (t + 0 < begin || t + 0 > end || !counts("bed layers", t)) continue
        w = thickness == "" ? 1 : cell("bed layers", t, thickness)
        sum += w*cell("bed layers", t, column)
        weights += w
    }
    put(column, !(("bed layers", column) in place) ? "" : \
        weights > 0 ? sum/weights : 0)
}

# The head, behind which are 99 % of the debris, over its reach and where it takes shape,
# and its tip: the flume's own page is on the tip
function putFront(    flume, head)
{
    flume = run ~ /^flume/
    head = flume ? "behindHead summary" : "head summary"
    putLast(flume ? "behind summary" : "front summary", "U h Fr tBegin tEnd")
    put("Uhead", last(head, "U"))
    put("hhead", last(head, "h"))
    put("Utip", last(flume ? "front summary" : "tip summary", "U"))
}

# Mean velocity of the bed in the range of the layers at the end; 0 for none
function restVelocity(    t, n, layer, i, h, sum, all)
{
    t = lastTime("bed layers")
    n = split("bouncing creeping stationary", layer, " ")
    for (i = 1; i <= n; i++)
    {
        h = cell("bed layers", t, layer[i])
        if (h == "") return ""
        sum += h*cell("bed layers", t, "U" layer[i])
        all += h
    }
    return all > 0 ? sum/all : 0
}

# Durations of the pore pressure at the probe
function putPressure(    p)
{
    split(pressure, p, " ")
    sub(/^>/, "", p[4])
    put("peak", p[1]); put("durationHigh", p[3]); put("dissipation", p[4])
    put("lambda", p[5])
}

function putErosion()
{
    putLast("bed summary", "H L")
    put("Lc", last("bed bedErosion", "xRaised"))
    put("LcFarthest", last("bed summary", "Lc"))
    putLast("bed summary", "Ue Ubed")
    putLast("bed bedErosion", "xEnd")
    putLast("bed summary", "netStart netEnd peakTime peakRate")
    begin = last("bed summary", "netStart")
    end = last("bed summary", "netEnd")
    if (end < 0) end = endTime    # still eroding at the end
    overErosion("bouncing"); overErosion("Ubouncing", "bouncing")
    overErosion("creeping"); overErosion("Ucreeping", "creeping")
    overErosion("stationary")
    put("Urest", restVelocity())
    putLast("load summary", "Fc M E Upassing hPassing")
}

END {
    # After a stop the looks are no longer at whole intervals
    t = lastTime("front surgeFront") + 0
    if (t < 0.98*endTime)
    {
        print "it ended at " t " s and not at " endTime " s"
        exit 1
    }
    put("run", run); put("hash", hash); put("code", code)
    put("ranks", ranks); put("seconds", seconds)
    put("endTime", endTime)
    putFront()
    if (run ~ /^flume/) putPressure()
    else putErosion()
    putLast("water massBalance", "waterError")
    put("grainsLeft", last("water massBalance", "left"))
    putLast("water massBalance", "grainsMissing")
    print head
    print row
}
