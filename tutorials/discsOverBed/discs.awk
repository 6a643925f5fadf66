#!/usr/bin/awk -f
# SPDX-License-Identifier: GPL-3.0-or-later
# Discs of the bed (type 1) and of the debris (type 2), in rows that do not touch, as a
# LIGGGHTS data file:
#   discs.awk -v bed=N -v debris=N -v pit=x -v pitEnd=x -v bottom=z -v tank=x \
#       -v xEnd=x -v top=z
#
# Each sphere gets the density with which it has the mass of a disc 10 mm thick.
function fill(type, n, x1, x2, z,    perRow, i, d, sphere, row)
{
    perRow = int((x2 - x1)/0.0042)
    for (i = 0; i < n; i++) {
        row = int(i/perRow)
        d = 0.003 + 0.001*rand()
        sphere = 2650*1.5*0.01/d
        line[++all] = sprintf("%d %d %.9g %.9g %.9g 0.005 %.9g", all, type, d, sphere,
            x1 + 0.0021 + 0.0042*(i % perRow) + 0.0003*(row % 2), z + 0.0021 + 0.0042*row)
    }
}
BEGIN {
    srand(1)
    fill(1, bed, pit + 0.001, pitEnd - 0.001, bottom)
    fill(2, debris, 0, tank, 0)
    print "Discs\n\n" all " atoms\n4 atom types\n"
    print "0 " xEnd " xlo xhi\n0 0.01 ylo yhi\n" bottom " " top " zlo zhi\n\nAtoms\n"
    for (i = 1; i <= all; i++) print line[i]
}
