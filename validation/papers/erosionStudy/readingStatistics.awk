# SPDX-License-Identifier: GPL-3.0-or-later
# How near H, L and L_c come to the paper's when they are read at other times than the
# end, as lines of statistics.csv; nothing until all runs have been read:
#
#   awk -F, -f readingStatistics.awk paper.csv readings.csv

FNR == 1 {
    for (i = 1; i <= NF; i++) name[FILENAME, i] = $i
    next
}

FNR == NR {
    nRuns++
    for (i = 2; i <= NF; i++)
    {
        paper[$1, name[FILENAME, i]] = $i
        sum[name[FILENAME, i]] += $i
    }
    next
}

function abs(x) { return x < 0 ? -x : x }

{
    if (!($3 in read)) times[++nTimes] = $3
    read[$3]++
    for (i = 4; i <= 6; i++)
    {
        q = name[FILENAME, i]
        off[q, $3] += 100*abs($i/paper[$1, q] - 1)/nRuns
        if ($3 == times[1]) constant[q] += 100*abs(sum[q]/nRuns/paper[$1, q] - 1)/nRuns
    }
}

END {
    split("H L Lc", quantity, " ")
    for (c = 1; c <= 3; c++)
        for (k = 1; k <= nTimes; k++)
        {
            q = quantity[c]; t = times[k]
            if (read[t] < nRuns) continue
            printf "reported,%s - mean absolute difference if read at %s s,%.3g,,%%\n", \
                q, t, off[q, t]
            printf "reported,%s - skill over the constant if read at %s s,%.2f,,\n", \
                q, t, 1 - off[q, t]/constant[q]
        }
}
