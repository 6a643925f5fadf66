# SPDX-License-Identifier: GPL-3.0-or-later
# Grains of all times for the page of surgePage, from grains.dat of a
# sideView, in order of time:
#
#   awk -v kept=FILE -f grains.awk TABLE... > moves
#
# moves: a line "t TIME" for each time, then a line "id x y z speed" for each grain that
# has moved or comes into view, and "id -" for each that has left or is hidden. Lengths in
# hundredths of half a grain (the smallest one), speeds in mm/s. kept: a line "scale unit
# all drawn speed x1 x2 y1 y2 z1 z2", then "id d type" for each grain that shows at some
# time; "drawn" is the mean over all times. A grain is hidden where grains lie over it, at
# its place and all around, and it is not at the middle, where the page may cut. It stays
# a time longer and comes a time earlier, so that what moves into view does so smoothly.

FNR == 1 {
    if (started++) endOfTime()
    times++
    n = 0
    now = part[split(FILENAME, part, "/") - 1]
}
/^#/ { next }
{
    n++
    id[n] = NF > 6 ? $7 + 0 : n
    x[n] = $1 + 0; y[n] = $2 + 0; z[n] = $3 + 0; d[n] = $4 + 0; v[n] = $5 + 0; type[n] = $6 + 0
}
END { endOfTime(); summary() }

# Sizes of the first grains set the width of the columns and the unit of lengths
function measure(    i)
{
    for (i = 1; i <= n; i++)
    {
        if (!smallest || d[i] < smallest) smallest = d[i]
        if (i == 1 || y[i] - d[i]/2 < y0) y0 = y[i] - d[i]/2
        if (i == 1 || y[i] + d[i]/2 > yEnd) yEnd = y[i] + d[i]/2
    }
    width = 1.5*smallest
    unit = smallest/200
    middle = (y0 + yEnd)/2
}

function column(x, y)
{
    return (int(x/width + 10000) - 5000)*16384 + int((y - y0)/width + 1000)
}

function raise(key, to) { if (!(key in top) || top[key] < to) top[key] = to }

# Top of the grains in each column; a large grain covers all those that it fills
function covered(    i, a, b, m, key)
{
    split("", top)
    for (i = 1; i <= n; i++)
    {
        key = place[i] = column(x[i], y[i])
        raise(key, z[i] + d[i]/2)
        m = int(d[i]/(2*width))
        for (a = -m; a <= m && m; a++)
            for (b = -m; b <= m; b++)
                if (a*a + b*b < m*m) raise(key + 16384*a + b, z[i] + d[i]/2)
    }
    split("", low)
    for (key in top)
    {
        low[key] = top[key]
        for (a = -1; a <= 1; a++)
            for (b = -1; b <= 1; b++)
                if (!((key + 16384*a + b) in top)) low[key] = -1e9
                else if (top[key + 16384*a + b] < low[key]) low[key] = top[key + 16384*a + b]
    }
}

function shows(i,    across)
{
    across = y[i] > middle ? y[i] - middle : middle - y[i]
    return across < d[i]/2 + 0.7*smallest \
        || z[i] + d[i]/2 > low[place[i]] - 1.1*smallest
}

function far(a, b, by) { return a - b > by || b - a > by }

# True if grain i is drawn at this time; one that comes into view is added to the time
# before, whose lines are not closed yet
function drawn(i, g)
{
    if (shows(i))
    {
        if (g in wasAt && wasAt[g] == times - 1 && !(g in lastX))
            put(g, wasX[g], wasY[g], wasZ[g], wasV[g])
        seenAt[g] = times
    }
    return g in seenAt && seenAt[g] >= times - 1
}

function steps(metres) { return int(metres/unit + 1e6) }

# Prints where grain g is, and keeps the ends of the range of all that are printed
function put(g, X, Y, Z, V)
{
    print g, X, Y, Z, V
    if (!printed++) { x1 = x2 = X; y1 = y2 = Y; z1 = z2 = Z }
    if (X < x1) x1 = X; else if (X > x2) x2 = X
    if (Y < y1) y1 = Y; else if (Y > y2) y2 = Y
    if (Z < z1) z1 = Z; else if (Z > z2) z2 = Z
}

function endOfTime(    i, j, g, X, Y, Z, V)
{
    if (n && !smallest) measure()
    covered()
    for (i = 1; i <= n; i++) inView[i] = drawn(i, id[i])
    print "t", now
    for (i = 1; i <= n; i++)
    {
        g = id[i]
        if (!(g in size))
        {
            order[++all] = g
            size[g] = d[i]
            kind[g] = type[i]
        }
        X = steps(x[i]); Y = steps(y[i]); Z = steps(z[i])
        V = int(1000*v[i] + 0.5)
        if (V > fastest) fastest = V
        wasX[g] = X; wasY[g] = Y; wasZ[g] = Z; wasV[g] = V
        wasAt[g] = times
        if (!inView[i]) continue
        shown++
        at[g] = times
        if (g in lastX && !far(X, lastX[g], 2) && !far(Y, lastY[g], 2) \
            && !far(Z, lastZ[g], 2) && !far(V, lastV[g], 5 + V/10)) continue
        put(g, X, Y, Z, V)
        lastX[g] = X; lastY[g] = Y; lastZ[g] = Z; lastV[g] = V
    }
    for (j = 1; j <= all; j++)
    {
        g = order[j]
        if (at[g] == times || !(g in lastX)) continue
        print g, "-"
        delete lastX[g]
    }
}

function summary(    j)
{
    print "scale", unit, all, int(shown/times + 0.5), fastest, x1, x2, y1, y2, z1, z2 > kept
    for (j = 1; j <= all; j++)
        if (order[j] in seenAt) print order[j], size[order[j]], kind[order[j]] > kept
}
