# SPDX-License-Identifier: GPL-3.0-or-later
# Of constant/flume: whether faces of the mesh stand at the barrier, 1.7 of 2.6 m along it,
# and end at its crest. Else topoSet finds no barrier, or floors of cells that float there.
#
#   awk -f onFaces.awk constant/flume

{ value[$1] = $2 + 0 }

function whole(x) { return (x - int(x + 0.5))^2 < 1e-6 }

END {
    if (!whole(value["cellsAlong"]/26))
        print "constant/flume: cellsAlong has to be a multiple of 26, for faces to stand" \
            " at the barrier"
    else if (!value["height"] || !whole(value["barrier"]*value["cellsUp"]/value["height"]))
        print "constant/flume: barrier*cellsUp/height has to be a whole number, for faces" \
            " to end at the barrier's crest"
    else
        exit 0
    exit 1
}
