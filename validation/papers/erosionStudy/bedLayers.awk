# SPDX-License-Identifier: GPL-3.0-or-later
# The layers of the bed, bouncing, creeping and stationary: their means over the net
# erosion, which lasts from begin to end, and how fast the bed still is at the end.
# Between runTables.awk and row.awk.

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
