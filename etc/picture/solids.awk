# SPDX-License-Identifier: GPL-3.0-or-later
# Closed bodies of POV-Ray from drawings (ASCII STL, in m), one for each file, as the
# macro Bodies; all but the first, the ground, are dark.

FNR == 1 { print (files++ ? closed(files > 2) : "#macro Bodies()") "\nmesh {" }
/^ *vertex/ {
    corner[n++] = sprintf("<%g,%g,%g>", $2, $4, $3)
    if (n == 3) print "triangle {" corner[0] "," corner[1] "," corner[2] "}"
    n %= 3
}
# What a body ends with
function closed(dark) { return "inside_vector y" (dark ? " texture { Built }" : "") "}" }

END { if (NR) print closed(files > 1) "\n#end" }
