# SPDX-License-Identifier: GPL-3.0-or-later
# Largest change of the longest distance in a clump over it, of all clumps: two files,
# the number of the clump in each line of the first, the place in each of the second.
# Variable: length_, as the template has it [m]

FNR == NR { clump[FNR] = $1; next }

{ place[clump[FNR], ++n[clump[FNR]]] = $1 " " $2 " " $3 }

END {
    for (c in n)
    {
        most = 0
        for (i = 1; i <= n[c]; ++i)
            for (j = 1; j < i; ++j)
            {
                split(place[c, i], a); split(place[c, j], b)
                d = sqrt((a[1] - b[1])^2 + (a[2] - b[2])^2 + (a[3] - b[3])^2)
                if (d > most) most = d
            }
        d = most/length_ - 1
        if (d < 0) d = -d
        if (d > worst) worst = d
        ++clumps
    }
    print clumps, worst + 0
}
