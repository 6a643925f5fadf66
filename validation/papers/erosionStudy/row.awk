# SPDX-License-Identifier: GPL-3.0-or-later
# The row of a run from the tables of its function objects: the last line of
# each, and means of the layers over the net erosion. Prints what is wrong where a
# number is missing or the run did not reach its end.
#
#   awk -v run= -v hash= -v code= -v version= -v ranks= -v seconds= -v endTime= [-v pressure=] \
#       -f runTables.awk -f bedLayers.awk -f row.awk tables...
#
# Of the bare flume, whose name begins with flume, it is another row: pressure is then
# what surgeFlume/probe.awk prints.

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

# Durations of the pore pressure at the probe; one that had not ended stays a text, >9.8,
# which a table of numbers refuses
function putPressure(    p)
{
    split(pressure, p, " ")
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
    put("run", run); put("hash", hash); put("code", code); put("version", version)
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
