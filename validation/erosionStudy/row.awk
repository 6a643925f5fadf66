# SPDX-License-Identifier: GPL-3.0-or-later
# The row of a run from the tables of its function objects: the last line of
# each, and means of the layers over the net erosion. Tells what is wrong where a
# number is not there or the run has not come to its end.
#
#   awk -v run= -v hash= -v code= -v ranks= -v seconds= -v endTime= -f row.awk \
#       tables...

# Object and table from .../<object>/<start>/<table>.dat
FNR == 1 {
    n = split(FILENAME, part, "/")
    table = part[n - 2] " " substr(part[n], 1, length(part[n]) - 4)
}

/^#/ {
    for (i = 2; i <= NF; i++) name[i - 1] = $i
    next
}

# A run that was stopped has tables of several starts, in any order
$1 + 0 >= latest[table] {
    latest[table] = $1 + 0
    for (i = 1; i <= NF; i++) value[table " " name[i]] = $i
}

table == "bed layers" {
    ++nLayers
    layerTime[nLayers] = $1
    for (i = 2; i <= NF; i++) layer[nLayers, name[i]] = $i
}

function put(heading, v)
{
    if (v == "")
    {
        print "its tables have no " heading
        exit 1
    }
    head = head (head == "" ? "" : ",") heading
    line = line (line == "" ? "" : ",") v
}

# heading, table and column
function last(heading, where)
{
    put(heading, (where in value) ? value[where] + 0 : "")
}

# Mean of a column of the layers over the net erosion
function overErosion(column,    k, sum, n)
{
    for (k = 1; k <= nLayers; k++)
        if (layerTime[k] >= begin && layerTime[k] <= end)
        {
            sum += layer[k, column]
            n++
        }
    put(column, n ? sum/n : 0)
}

END {
    t = value["front surgeFront Time"]
    # After a stop the looks are no longer at whole intervals
    if (t < 0.98*endTime)
    {
        print "it ended at " t " s and not at " endTime " s"
        exit 1
    }
    put("run", run); put("hash", hash); put("code", code)
    put("ranks", ranks); put("seconds", seconds)
    put("endTime", endTime)
    last("U", "front summary U")
    last("h", "front summary h")
    last("Fr", "front summary Fr")
    last("tBegin", "front summary tBegin")
    last("tEnd", "front summary tEnd")
    last("H", "bed summary H")
    last("L", "bed summary L")
    last("Lc", "bed summary Lc")
    last("Ue", "bed summary Ue")
    last("xEnd", "bed bedErosion xEnd")
    last("netStart", "bed summary netStart")
    last("netEnd", "bed summary netEnd")
    last("peakTime", "bed summary peakTime")
    last("peakRate", "bed summary peakRate")
    begin = value["bed summary netStart"]
    end = value["bed summary netEnd"]
    overErosion("bouncing"); overErosion("Ubouncing")
    overErosion("creeping"); overErosion("Ucreeping")
    overErosion("stationary")
    last("Fc", "load summary Fc")
    last("M", "load summary M")
    last("E", "load summary E")
    last("waterError", "water massBalance waterError")
    last("grainsLeft", "water massBalance left")
    last("grainsMissing", "water massBalance grainsMissing")
    print head
    print line
}
