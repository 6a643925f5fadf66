# SPDX-License-Identifier: GPL-3.0-or-later
# What shows of a flume whose walls are drawings: the box of the cells in cells.dat,
# nearer than y = cut left out. range: x from,to; upTo: height, where not all shows.

/^#/ { next }
!n++ { x0 = x1 = $1; y1 = $2; z1 = $3; size = $4 }
{
    if ($1 < x0) x0 = $1 + 0
    if ($1 > x1) x1 = $1 + 0
    if ($2 > y1) y1 = $2 + 0
    if ($3 > z1) z1 = $3 + 0
}
END {
    split(range == "" ? x0 - size/2 "," x1 + size/2 : range, end, ",")
    printf "#declare X0 = %g; #declare X1 = %g; #declare Y0 = %g; #declare Y1 = %g; " \
        "#declare Z1 = %g; #declare Back = 0;\n", end[1], end[2], cut, y1 + size/2, \
        upTo ? upTo : z1 + size/2
}
