# SPDX-License-Identifier: GPL-3.0-or-later
# Of constant/flume: whether the barrier is within the mesh, and faces of it stand there,
# 1.7 of 2.6 m along it, and end at its crest. Else topoSet finds no barrier, or floors
# of cells that float there.
#
#   awk -f onFaces.awk constant/flume

{ value[$1] = $2 + 0 }

function whole(x) { return (x - int(x + 0.5))^2 < 1e-6 }

END {
    if (value["barrier"] <= 0 || value["barrier"] >= value["height"])
        print "constant/flume: barrier is " value["barrier"] " m, but has to be above 0 and" \
            " below the height of the mesh, " value["height"] " m"
    else if (!whole(value["cellsAlong"]/26))
        print "constant/flume: cellsAlong has to be a multiple of 26, for faces to stand" \
            " at the barrier"
    else if (!value["height"] || !whole(value["barrier"]*value["cellsUp"]/value["height"]))
        print "constant/flume: barrier*cellsUp/height has to be a whole number, for faces" \
            " to end at the barrier's crest"
    else
        exit 0
    exit 1
}
