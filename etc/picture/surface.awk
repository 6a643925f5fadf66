# SPDX-License-Identifier: GPL-3.0-or-later
# The surface of the water of one moment as a film of POV-Ray, from an ASCII STL.

BEGIN { print "mesh {" }
/^ *vertex/ {
    corner[n++] = sprintf("<%g,%g,%g>", $2, $4, $3)
    if (n == 3)
    {
        print "triangle {" corner[0] "," corner[1] "," corner[2] "}"
        triangles++
    }
    n %= 3
}
END {
    if (!triangles) print "triangle {<0,-9,0>,<1e-3,-9,0>,<0,-9,1e-3>}"
    print "texture { Film } }"
}
