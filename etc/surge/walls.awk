# SPDX-License-Identifier: GPL-3.0-or-later
# Triangles of ASCII STL files for the page of surgePage, as a JSON list of coordinates.
# Those at right angles to y, as side walls are, stay away, since one looks through them.

function put(    i)
{
    if (p[2] == p[5] && p[5] == p[8]) return
    for (i = 1; i <= 9; i++) printf "%s%.5g", (any++ ? "," : ""), p[i]
}

BEGIN { printf "[" }
$1 == "outer" { n = 0 }
$1 == "vertex" { p[++n] = $2 + 0; p[++n] = $3 + 0; p[++n] = $4 + 0 }
$1 == "endloop" && n == 9 { put() }
END { print "]" }
