# SPDX-License-Identifier: GPL-3.0-or-later
# The narrowest opening of a dam (ASCII STL): the plane across the chute in the middle of
# the body cuts it, and along y gaps lie between its parts, at forty heights. Prints
# width, y of the middle, z; nothing where no gap lies between parts.
#
#   awk -f openings.awk dam.m.stl

/^ *vertex/ {
    n++
    x[n] = $2; y[n] = $3; z[n] = $4
    if (n == 1 || $2 + 0 < from) from = $2 + 0
    if (n == 1 || $2 + 0 > to) to = $2 + 0
    if (n == 1 || $4 + 0 < low) low = $4 + 0
    if (n == 1 || $4 + 0 > high) high = $4 + 0
}

# cut(a, b): where the edge from corner a to b meets the plane, as endY, endZ
function cut(a, b,    s)
{
    if ((x[a] < at) == (x[b] < at)) return
    s = (at - x[a])/(x[b] - x[a])
    ends++
    endY[ends] = y[a] + s*(y[b] - y[a])
    endZ[ends] = z[a] + s*(z[b] - z[a])
}

# The pieces of the outline in the plane
function outline(    i)
{
    for (i = 1; i <= n; i += 3)
    {
        ends = 0
        cut(i, i + 1); cut(i + 1, i + 2); cut(i + 2, i)
        if (ends != 2) continue
        pieces++
        y1[pieces] = endY[1]; z1[pieces] = endZ[1]
        y2[pieces] = endY[2]; z2[pieces] = endZ[2]
    }
}

# Crossings of the outline with the height h, sorted by y in place; returns their number
function crossings(h,    i, j, c, v)
{
    for (i = 1; i <= pieces; i++)
    {
        if ((z1[i] < h) == (z2[i] < h)) continue
        v = y1[i] + (h - z1[i])/(z2[i] - z1[i])*(y2[i] - y1[i])
        for (j = c++; j > 0 && place[j] > v; j--) place[j + 1] = place[j]
        place[j + 1] = v
    }
    return c
}

END {
    at = (from + to)/2
    outline()
    for (level = 0.5; level < 40; level++)
    {
        h = low + level/40*(high - low)
        c = crossings(h)
        for (i = 2; i < c; i += 2)
            if (!found || place[i + 1] - place[i] < width + 1e-9)
            {
                found = 1
                width = place[i + 1] - place[i]
                middle = (place[i] + place[i + 1])/2
                height = h
            }
    }
    if (found) printf "%.4g %.4g %.4g\n", width, middle, height
}
