# SPDX-License-Identifier: GPL-3.0-or-later
# Which of a row's readings are compared, for the programs that read rows: into
# ours[run, column] of the present row, whose headings are name[2] and on.

BEGIN {
    g = 9.81
    cosSlope = cos(20*atan2(0, -1)/180)
}

# readRow run scale: a row that has them gives U and h where heads take shape, in place of
# those over the whole reach, and Fr and E with them (Eqs 12 and 15); the paper's U_e is
# that of the whole bed, and what moves is kept beside it. A slice of a fifth of the width
# has a fifth of the mass and energy: scale 5. What a row does not have stays empty
function readRow(run, scale,    i, U, h, Fr)
{
    for (i = 2; i <= NF; i++) ours[run, name[i]] = $i
    if (ours[run, "E"] != "") ours[run, "E"] *= scale
    ours[run, "Umoving"] = ours[run, "Ue"]
    ours[run, "Ue"] = (run, "Ubed") in ours ? ours[run, "Ubed"] : ""
    if (ours[run, "Uhead"] == "") return
    ours[run, "Ureach"] = ours[run, "U"]
    ours[run, "hreach"] = ours[run, "h"]
    U = ours[run, "U"] = ours[run, "Uhead"]
    h = ours[run, "h"] = ours[run, "hhead"]
    Fr = ours[run, "Fr"] = ours[run, "E"] = ""
    if (h == "") return
    Fr = ours[run, "Fr"] = h > 0 ? U/sqrt(g*h*cosSlope) : 0
    ours[run, "E"] = scale*ours[run, "M"]*g*h*(1 + Fr*Fr/2)
}

# As "readRow" sees them: two runs compare in U, h, Fr and E where this is the same
function whereRead(run)
{
    return ours[run, "Uhead"] != "" ? "head" : "reach"
}
