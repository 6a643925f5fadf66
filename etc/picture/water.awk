# SPDX-License-Identifier: GPL-3.0-or-later
# The water of one moment as a solid of POV-Ray:
#
#   awk -v name=WATER [-v range=x1,x2 -v upTo=z] -f waterColumns.awk -f water.awk cells.dat
#
# name: of what it writes, the heights as two pictures and the corners of the flume; range
# and upTo, where not all shows.

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
