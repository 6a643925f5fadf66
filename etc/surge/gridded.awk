# SPDX-License-Identifier: GPL-3.0-or-later
# Cells of a sideView (cells.dat) on a mesh that is no grid of boxes, as the mean values
# in a grid, for waterColumns.awk:
#
#   awk [-v across=WIDTH] -f gridded.awk cells.dat
#
# Cells that are a grid of boxes stay as they are. across: width of the domain [m], for
# a mesh of one cell across.

/^#/ { next }
{
    line[++n] = $0
    x[n] = $1 + 0; y[n] = $2 + 0; z[n] = $3 + 0; size[n] = $4 + 0; alpha[n] = $5 + 0
    sum += $4
    if (!($1 in xs)) { xs[$1]; nx++ }
    if (!($2 in ys)) { ys[$2]; ny++ }
    if (!($3 in zs)) { zs[$3]; nz++ }
}
END {
    if (n == nx*ny*nz || !n) for (i = 1; i <= n; i++) print line[i]
    else grid()
}

function lowest(list,    i, low)
{
    low = list[1]
    for (i = 2; i <= n; i++) if (list[i] < low) low = list[i]
    return low
}

function grid(    i, j, k, c, w, v, x0, y0, z0, a)
{
    w = 1.2*sum/n
    x0 = lowest(x) - w/2; y0 = lowest(y) - w/2; z0 = lowest(z) - w/2
    for (c = 1; c <= n; c++)
    {
        i = int((x[c] - x0)/w); j = int((y[c] - y0)/w); k = int((z[c] - z0)/w)
        v = size[c]^3
        volume[i, j, k] += v; water[i, j, k] += alpha[c]*v
        if (i > ni) ni = i
        if (j > nj) nj = j
        if (k > nk) nk = k
    }
    if (nj == 0 && across) v = (w*w*across)^(1/3); else v = w
    for (i = 0; i <= ni; i++)
        for (j = 0; j <= nj; j++)
            for (k = 0; k <= nk; k++)
            {
                a = mean(i, j, k)
                # Larger cells leave a gap
                if (a < 0 && mean(i, j, k - 1) >= 0 && mean(i, j, k + 1) >= 0)
                    a = (mean(i, j, k - 1) + mean(i, j, k + 1))/2
                printf "%.8g %.8g %.8g %.8g %.6g 0\n", x0 + (i + 0.5)*w, y0 + (j + 0.5)*w, \
                    z0 + (k + 0.5)*w, v, (a < 0 ? 0 : a)
            }
}

function mean(i, j, k)
{
    return (i, j, k) in volume ? water[i, j, k]/volume[i, j, k] : -1
}
