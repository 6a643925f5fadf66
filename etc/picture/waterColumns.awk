# SPDX-License-Identifier: GPL-3.0-or-later
# The water of one moment in each column of cells, from cells.dat of a sideView on a mesh
# of boxes. The surface lies where the uppermost water ends; below it is as much water as
# the column holds in one piece, so that the volume is true also where a surge is one cell
# deep. Before water.awk, which draws it.

/^#/ { next }
{
    xs[$1 + 0]; ys[$2 + 0]; zs[$3 + 0]
    alpha[$1 + 0, $2 + 0, $3 + 0] = $5
    size = $4; n++
}

# Sorts the keys of a set into list[1..n], returns n
function sorted(set, list,    n, key, i, v)
{
    for (key in set)
    {
        v = key + 0
        for (i = n++; i > 0 && list[i] > v; i--) list[i + 1] = list[i]
        list[i + 1] = v
    }
    return n
}

function share(i, j, k) { return k < 1 ? 0 : alpha[x[i], y[j], z[k]] + 0 }

# Surface and underside of the water in column i, j
function column(i, j,    k, a, sum)
{
    for (k = nz; k > 0 && share(i, j, k) < 0.05; k--);
    if (k < 1) return
    for (; ; k--)
    {
        a = share(i, j, k)
        sum += a*dz
        if (a >= 0.5 || share(i, j, k - 1) < a) break
    }
    top[i, j] = z[k] - dz/2 + sum
    for (k--; k > 0 && share(i, j, k) >= 0.02; k--) sum += share(i, j, k)*dz
    low[i, j] = top[i, j] - sum
}

# A dry column next to wet ones: there the water ends, at the mean of their undersides
function margin(i, j,    di, dj, n, sum)
{
    for (di = -1; di <= 1; di++)
        for (dj = -1; dj <= 1; dj++)
            if ((i + di, j + dj) in low && ++n) sum += low[i + di, j + dj]
    return n ? sum/n : 0
}

END {
    nx = sorted(xs, x); ny = sorted(ys, y); nz = sorted(zs, z)
    dx = (x[nx] - x[1])/(nx - 1); dz = (z[nz] - z[1])/(nz - 1)
    dy = ny > 1 ? (y[ny] - y[1])/(ny - 1) : size^3/(dx*dz)
    height = z[nz] + dz/2
    if (n != nx*ny*nz)
        print "The cells are no grid of boxes: their water is left out" > "/dev/stderr"
    else for (i = 1; i <= nx; i++) for (j = 1; j <= ny; j++) column(i, j)
}
