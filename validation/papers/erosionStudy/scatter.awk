# SPDX-License-Identifier: GPL-3.0-or-later
# How far runs scatter that differ in nothing but the seed of the packing: standard
# deviation of each column, pooled over the runs that were repeated.
#
#   awk -F, -v on=-slice -f head.awk -f scatter.awk rows...
#
# <run>-seed2 and so on belong to <run>; on is -slice if they are slices. Lines "<column>
# <standard deviation>" and "freedom <degrees of freedom>"; none without repeated runs.
# Runs whose U and h were read elsewhere along the chute are not
# repetitions of each other.

FNR == 1 {
    for (i = 1; i <= NF; i++) name[i] = $i
    next
}

{
    readRow($1, on == "-slice" ? 5 : 1)
    base = $1
    sub(/-seed[0-9]$/, "", base)
    base = base " " whereRead($1)
    member[base, ++n[base]] = $1
    for (i = 2; i <= NF; i++) columns[name[i]]
}

# Sum of squares of a column about the mean of its run
function squares(base, q,    i, mean, sum)
{
    for (i = 1; i <= n[base]; i++) mean += ours[member[base, i], q]/n[base]
    for (i = 1; i <= n[base]; i++) sum += (ours[member[base, i], q] - mean)^2
    return sum
}

# True if all repeated runs have it
function isRead(q,    base, i)
{
    for (base in n)
        for (i = 1; i <= n[base]; i++)
            if (ours[member[base, i], q] == "") return 0
    return 1
}

END {
    for (base in n) freedom += n[base] - 1
    if (!freedom) exit
    print "freedom", freedom
    for (q in columns)
    {
        if (!isRead(q)) continue
        sum = 0
        for (base in n) sum += squares(base, q)
        printf "%s %.17g\n", q, sqrt(sum/freedom)
    }
}
