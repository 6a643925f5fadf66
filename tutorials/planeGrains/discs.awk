#!/usr/bin/awk -f
# SPDX-License-Identifier: GPL-3.0-or-later
# Discs in a column, in rows that do not touch, as a LIGGGHTS data file:
#   discs.awk -v thickness=0.01 -v density=2650
#
# LIGGGHTS knows spheres: each gets the density with which it has the mass of a disc as
# thick as the mesh is wide.
BEGIN {
    srand(1)
    pi = atan2(0, -1)
    for (row = 0; row < 18; row++)
        for (column = 0; column < 14; column++) {
            d = 0.003 + 0.001*rand()
            x = 0.0025 + 0.0042*(column + 0.3*(row % 2))
            z = 0.0025 + 0.0042*row
            sphere = density*(pi*d*d/4*thickness)/(pi*d*d*d/6)
            line[++n] = sprintf("%d 1 %.9g %.9g %.9g %.9g %.9g", n, d, sphere, x,
                thickness/2, z)
        }
    print "Discs\n\n" n " atoms\n1 atom types\n"
    print "0 0.3 xlo xhi\n0 " thickness " ylo yhi\n0 0.1 zlo zhi\n\nAtoms\n"
    for (i = 1; i <= n; i++) print line[i]
}
