# SPDX-License-Identifier: GPL-3.0-or-later
# How far runs scatter that differ in nothing but the seed of the packing: standard
# deviation of each column, pooled over the runs that were repeated.
#
#   awk -F, -v on=-slice -f scatter.awk rows...
#
# <run>-seed2 and so on belong to <run>; on is -slice if they are slices. Lines "<column>
# <standard deviation>" and "freedom <degrees of freedom>"; none without repeated runs.

FNR == 1 {
    for (i = 1; i <= NF; i++) name[i] = $i
    next
}

# A slice of a fifth of the width has a fifth of the energy
{
    base = $1
    sub(/-seed[0-9]$/, "", base)
    n[base]++
    for (i = 2; i <= NF; i++)
    {
        columns[name[i]]
        scale = name[i] == "E" && on == "-slice" ? 5 : 1
        value[base, n[base], name[i]] = scale*$i
    }
}

# Sum of squares of a column about the mean of its run
function squares(base, q,    i, mean, sum)
{
    for (i = 1; i <= n[base]; i++) mean += value[base, i, q]/n[base]
    for (i = 1; i <= n[base]; i++) sum += (value[base, i, q] - mean)^2
    return sum
}

END {
    for (base in n) freedom += n[base] - 1
    if (!freedom) exit
    print "freedom", freedom
    for (q in columns)
    {
        sum = 0
        for (base in n) sum += squares(base, q)
        printf "%s %.17g\n", q, sqrt(sum/freedom)
    }
}
