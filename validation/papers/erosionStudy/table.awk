# SPDX-License-Identifier: GPL-3.0-or-later
# The paper's results beside ours, a line for each run. Differences are in % of the
# paper's value. L is the eroded length beyond x = 0.6 m, LFromWall reaches from x = 0 to
# the end of the scar; both are compared with the paper's L, see README.md.
#
#   awk -v suffix=-slice -v states=FILE -f head.awk -f paperTable.awk -f table.awk paper.csv rows...
#
# states: lines "<run> <what became of it>" for the runs without a row.

BEGIN {
    nColumns = split("Fr H L Lc U Ue h E", column, " ")
    while ((getline line < states) > 0)
    {
        run = line
        sub(/ .*/, "", run)
        sub(/^[^ ]* /, "", line)
        state[run] = line
    }
}

# In % of the paper's value
function difference(v, reference)
{
    return v == "" ? "" : sprintf("%.1f", 100*(v/reference - 1))
}

{
    run = $1
    if (suffix != "" && !sub(suffix "$", "", run)) next
    if (!(run in M)) next
    scale = suffix == "" ? 1 : 5
    state[run] = "done"
    readRow(run, scale)
    ours[run, "LFromWall"] = ours[run, "xEnd"]
    ours[run, "LFromWallDifference"] = difference(ours[run, "xEnd"], paper[run, "L"])
    ours[run, "LcFarthestDifference"] = \
        difference(ours[run, "LcFarthest"], paper[run, "Lc"])
    ours[run, "UtipDifference"] = difference(ours[run, "Utip"], paper[run, "U"])
    ours[run, "UpassingDifference"] = \
        difference(ours[run, "Upassing"], paper[run, "U"])
}

END {
    printf "run,state,D,M,V,FrPrinted,EPrinted"
    for (c = 1; c <= nColumns; c++)
        printf ",%s,%sPaper,%sDifference", column[c], column[c], column[c]
    nMore = split("Fc bouncing creeping netStart netEnd peakTime hash code " \
        "LFromWall LFromWallDifference tBegin tEnd stationary Ubouncing Ucreeping " \
        "LcFarthest LcFarthestDifference Utip UtipDifference " \
        "Upassing UpassingDifference hPassing " \
        "UPrinted FrAsPrinted Umoving Ureach hreach", more, " ")
    for (i = 1; i <= nMore; i++) printf ",%s", more[i]
    print ""

    for (r = 1; r <= nRuns; r++)
    {
        run = runs[r]
        printf "%s,%s,%s,%s,%s,%s,%.4g", run, \
            (run in state) ? state[run] : "not run", D[run], M[run], V[run], \
            printed[run], M[run]*g*paper[run, "h"]*(1 + printed[run]^2/2)
        for (c = 1; c <= nColumns; c++)
        {
            q = column[c]
            v = (run, q) in ours && ours[run, q] != "" ? sprintf("%.4g", ours[run, q]) : ""
            printf ",%s,%.4g,%s", v, paper[run, q], \
                difference(v == "" ? v : ours[run, q], paper[run, q])
        }
        for (i = 1; i <= nMore; i++) printf ",%s", ours[run, more[i]]
        print ""
    }
}
