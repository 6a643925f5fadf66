# SPDX-License-Identifier: GPL-3.0-or-later
# Lines "check,quantity,value,reference,unit" for statistics.csv on one quantity, from the
# output of tableStatistics -compare:
#
#   awk -F, -v q=H -v goal=5 -v bound=8.5 -v nDone=24 -v nRuns=24 -v enough=9 -v scatter= \
#       -v ofSlices= -f compare.awk
#
# goal and bound [%] of the mean absolute difference; with them 0.75 is the bound of the
# rank correlation. That of a constant, the paper's mean of these runs, is reported.
# scatter: standard deviation between packings, empty where it is not known. Correlations
# only of "enough" runs, since with few of them mass, diameter and solid fraction rise
# together.

{ of[$1] = $2 }

function writeRow(check, what, number, reference, unit)
{
    printf "%s,%s - %s,%s,%s,%s\n", nDone == nRuns ? check : "reported", q, what, \
        number, reference, unit
}

END {
    # Runs that were done before it was read
    if (of["pairs"] < nDone)
    {
        writeRow("reported", "runs without it", nDone - of["pairs"])
        exit
    }
    writeRow(goal ? "atMost" : "reported", "mean absolute difference", \
        sprintf("%.3g", of["meanAbsoluteDifference"]), bound, "%")
    if (goal)
        writeRow("reported", "goal of the mean absolute difference", goal, "", "%")
    writeRow("reported", "that of the paper's mean for every run", \
        sprintf("%.3g", of["constantDifference"]), "", "%")
    writeRow("reported", "skill over that constant", sprintf("%.2f", of["skill"]))
    if (nDone < enough) exit
    writeRow(goal ? "atLeast" : "reported", "rank correlation", \
        sprintf("%.3f", of["rankCorrelation"]), goal ? 0.75 : "")
    if (scatter == "") exit
    writeRow("reported", "scatter between packings" ofSlices, \
        sprintf("%.2g", 100*scatter/of["mean"]), "", "% of the mean")
    writeRow("reported", "rank correlation without the chance of the packings - 90 %", \
        sprintf("%.2f to %.2f", of["rankCorrelationFrom"], of["rankCorrelationTo"]))
}
