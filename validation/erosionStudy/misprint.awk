# SPDX-License-Identifier: GPL-3.0-or-later
# The misprint in the paper's table, from the table alone: does Eq 12 give the Fr of a
# run from its U and h, as printed, and with the labels of one column arranged anew?
#
#   awk -F, -f misprint.awk paper.csv
#
# Tells lines "check,quantity,value,wanted,unit" as statistics.awk does. An arrangement is
# one of the 6 permutations of the labels D, M, V with each of the 6 orders of the three
# levels of each label, the reversed one among them: 6^4 = 1296 of each of the columns U, h
# and Fr. They are all of these, so that none is chosen by eye.

function abs(x) { return x < 0 ? -x : x }

# How near the Froude number of U and h comes to Fr, over all runs, when the column
# "moved" is that of the arrangement: labels permuted by p, levels of D, M, V by i, j, k.
# Sets within, off and rounded
function try(moved, p, i, j, k,    d, m, v, here, there, u, h, f, fr, level, order)
{
    within = off = rounded = 0
    order[1] = orders[i]; order[2] = orders[j]; order[3] = orders[k]
    for (d = 1; d <= 3; d++) for (m = 1; m <= 3; m++) for (v = 1; v <= 3; v++)
    {
        here = d m v
        there = ""
        for (level = 1; level <= 3; level++)
            there = there substr(order[level], substr(here, substr(p, level, 1), 1), 1)
        u = U[moved == "U" ? there : here]
        h = H[moved == "h" ? there : here]
        fr = Fr[moved == "Fr" ? there : here]
        f = u/root/sqrt(h)
        within += abs(f/fr - 1) <= 0.011
        off += 100*abs(f/fr - 1)/27
        # Half of the last printed digit of each
        rounded += (u - 0.005)/root/sqrt(h + 0.0005) <= fr + 0.005 \
            && (u + 0.005)/root/sqrt(h - 0.0005) >= fr - 0.005
    }
}

# All arrangements of a column but the printed and the exchanged one: the best of them
function tryAll(moved,    p, i, j, k)
{
    for (p = 1; p <= 6; p++) for (i = 1; i <= 6; i++)
        for (j = 1; j <= 6; j++) for (k = 1; k <= 6; k++)
        {
            if (i == 1 && j == 1 && k == 1 \
                && (p == 1 || moved == "U" && orders[p] == exchange)) continue
            try(moved, orders[p], i, j, k)
            tried[moved]++
            if (within > most[moved]) most[moved] = within
            if (rounded > mostRounded[moved]) mostRounded[moved] = rounded
            if (!(moved in least) || off < least[moved]) least[moved] = off
        }
}

# Correlation (Pearson) of Fr, of the run itself or of that with D and M exchanged, and y
function correlation(moved, y,    c, x, n, mx, my, xy, xx, yy)
{
    for (c in Fr) { mx += Fr[c]/27; my += y[c]/27 }
    for (c in Fr)
    {
        x = (moved ? Fr[substr(c, 2, 1) substr(c, 1, 1) substr(c, 3, 1)] : Fr[c]) - mx
        xy += x*(y[c] - my)
        xx += x^2
        yy += (y[c] - my)^2
    }
    return xy/sqrt(xx*yy)
}

# Largest difference to the correlations of Fr with H, L and L_c that the paper states
function fromStated(moved,    a, b, c)
{
    a = abs(correlation(moved, depth) - 0.706)
    b = abs(correlation(moved, reach) - 0.549)
    c = abs(correlation(moved, carried) - 0.526)
    return a > b ? a > c ? a : c : b > c ? b : c
}

function tell(check, quantity, value, wanted, unit)
{
    printf "%s,the paper's table - %s,%s,%s,%s\n", check, quantity, value, wanted, unit
}

BEGIN {
    split("123 132 213 231 312 321", orders, " ")
    exchange = "213"
    root = sqrt(9.81*cos(20*atan2(0, -1)/180))
}

NR == 1 {
    for (i = 1; i <= NF; i++) c[$i] = i
    next
}

{
    split($1, label, /[DMV]/)
    cell = label[2] - 1
    cell = cell (label[3] - 80)/35 (label[4] - 40)/5
    Fr[cell] = $c["Fr"]; U[cell] = $c["UPrinted"]; H[cell] = $c["h"]
    depth[cell] = $c["H"]; reach[cell] = $c["L"]; carried[cell] = $c["Lc"]
    corrected[cell] = $c["U"]
}

END {
    for (cell in U)
        same += corrected[cell] == U[substr(cell, 2, 1) substr(cell, 1, 1) substr(cell, 3)]
    tell("atLeast", "runs whose corrected U is the printed one with D and M exchanged", \
        same, 27)

    try("U", exchange, 1, 1, 1)
    tell("atLeast", "runs whose Fr Eq 12 gives within 1.1 %; U corrected", within, 27)
    tell("reported", "mean difference; U corrected", sprintf("%.2g", off), "", "%")
    tell("reported", "runs that it gives as far as digits are printed; U corrected", rounded)
    try("U", "123", 1, 1, 1)
    tell("within", "runs that it misses by more; U as printed", 27 - within, "18 0")
    tell("reported", "mean difference; U as printed", sprintf("%.3g", off), "", "%")
    tell("reported", "runs that it gives as far as digits are printed; U as printed", \
        rounded)

    n = split("U h Fr", column, " ")
    for (i = 1; i <= n; i++)
    {
        q = column[i]
        tryAll(q)
        tell("atMost", "most runs within 1.1 % of " tried[q] \
            " other arrangements of the labels of " q, most[q], 26)
        tell("reported", "their least mean difference; " q, sprintf("%.2g", least[q]), "", "%")
        tell("reported", "the most as far as digits are printed; " q, mostRounded[q])
    }

    tell("atMost", "r of Fr with H; L and L_c: largest difference to those stated", \
        sprintf("%.3f", fromStated(0)), 0.01)
    tell("reported", "the same if Fr and h had moved and not U", \
        sprintf("%.3f", fromStated(1)))
}
