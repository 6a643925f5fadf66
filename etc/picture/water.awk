# SPDX-License-Identifier: GPL-3.0-or-later
# The water of one moment as a solid of POV-Ray, from cells.dat of a sideView on a mesh
# of boxes. In each column of cells the surface lies where the uppermost water ends;
# below it is as much water as the column holds in one piece, so that the volume is true
# also where a surge is one cell deep. Set: name, of what it writes (the heights as two
# pictures, the corners of the flume); range, x from,to, and upTo, z, where not all shows.

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

function within(i, n) { return i < 1 ? 1 : i > n ? n : i }

# Heights as a picture, a pixel a column and one more around, the farthest row first
function picture(f, file,    i, j, h)
{
    printf "P2\n%d %d\n65535\n", nx + 2, ny + 2 > file
    for (j = ny + 1; j >= 0; j--)
        for (i = 0; i <= nx + 1; i++)
        {
            h = f[within(i, nx), within(j, ny)]/height
            printf "%d\n", 65535*(h < 0 ? 0 : h > 1 ? 1 : h) > file
        }
    close(file)
}

function field(file)
{
    return sprintf("height_field { pgm \"%s\" smooth scale <%g, %g, %g> " \
        "translate <%g, 0, %g> }", file, (nx + 1)*dx, height, (ny + 1)*dy, \
        x[1] - dx, y[1] - dy)
}

END {
    nx = sorted(xs, x); ny = sorted(ys, y); nz = sorted(zs, z)
    dx = (x[nx] - x[1])/(nx - 1); dz = (z[nz] - z[1])/(nz - 1)
    dy = ny > 1 ? (y[ny] - y[1])/(ny - 1) : size^3/(dx*dz)
    height = z[nz] + dz/2
    if (n != nx*ny*nz)
        print "The cells are no grid of boxes: their water is left out" > "/dev/stderr"
    else for (i = 1; i <= nx; i++) for (j = 1; j <= ny; j++) column(i, j)
    split(range == "" ? x[1] - dx/2 "," x[nx] + dx/2 : range, end, ",")
    printf "#declare X0 = %g; #declare X1 = %g; #declare Y0 = %g; #declare Y1 = %g; " \
        "#declare Z1 = %g; #declare Back = %d;\n", end[1], end[2], y[1] - dy/2, \
        y[ny] + dy/2, upTo ? upTo : height, (end[1] < x[1]) > (name ".flume.inc")
    if (!length(top)) exit
    for (i = 1; i <= nx; i++) for (j = 1; j <= ny; j++)
    {
        above[i, j] = (i, j) in top ? top[i, j] : margin(i, j)
        below[i, j] = (i, j) in top ? low[i, j] : above[i, j] + 0.001
    }
    picture(above, name ".top.pgm")
    picture(below, name ".low.pgm")
    # A millimetre beyond the walls: grains are pressed into them a little
    printf "intersection {\n    %s\n    %s\n    box { <%g, 1e-4, %g>, <%g, %g, %g> }\n" \
        "    material { Water }\n}\n", field(name ".top.pgm"), \
        "object { " field(name ".low.pgm") " inverse }", end[1] - 1e-3, \
        y[1] - dy/2 - 1e-3, end[2] + 1e-3, height, y[ny] + dy/2 + 1e-3
}
