# SPDX-License-Identifier: GPL-3.0-or-later
# Arrangements of the labels of one column of the paper's table: an arrangement is one of
# the 6 permutations of the labels D, M, V with each of the 6 orders of the three levels of
# each label, the reversed one among them: 6^4 = 1296 of each of the columns U, h and Fr.
# They are all of these, so that none is chosen by eye. Before misprint.awk, which has the
# columns as U, H and Fr.

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

BEGIN {
    split("123 132 213 231 312 321", orders, " ")
    exchange = "213"
    root = sqrt(9.81*cos(20*atan2(0, -1)/180))
}
