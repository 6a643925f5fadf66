# SPDX-License-Identifier: GPL-3.0-or-later
# For each mechanism: the one with the most similar effect, and what distinguishes the
# two: the part of its effect that no multiple of the other's makes, and the channel
# that has most of that part.
# From the effects that effects.awk writes, mechanism,sample,effect:
#
#   awk -F, -f likeness.awk vectors.csv

{
    if (!($1 in known)) { known[$1] = 1; name[++mechanisms] = $1 }
    if (!($2 in place)) { place[$2] = 1; sample[++samples] = $2 }
    effect[$1, $2] = $3
}

function product(a, b,    k, sum)
{
    for (k = 1; k <= samples; k++) sum += effect[a, sample[k]]*effect[b, sample[k]]
    return sum
}

# Leaves in most the channel with most of what is left, and gives all of that
function left(a, b,    k, scale, d, c, sum, of, largest)
{
    scale = product(a, b)/product(b, b)
    for (k = 1; k <= samples; k++)
    {
        d = effect[a, sample[k]] - scale*effect[b, sample[k]]
        c = substr(sample[k], 1, index(sample[k], "_") - 1)
        of[c] += d*d
        sum += d*d
    }
    for (c in of) if (of[c] > largest) { largest = of[c]; most = c }
    return sqrt(sum)
}

END {
    print "mechanism,effect,most like,cosine,left,distinguished by"
    for (i = 1; i <= mechanisms; i++)
    {
        best = 0
        for (j = 1; j <= mechanisms; j++)
        {
            if (i == j) continue
            x = product(name[i], name[j])/sqrt(product(name[i], name[i])*product(name[j], name[j]))
            if (!best || x*x > largest*largest) { best = j; largest = x }
        }
        rest = left(name[i], name[best])
        printf "%s,%.1f,%s,%.2f,%.1f,%s\n", name[i], sqrt(product(name[i], name[i])),
            name[best], largest, rest, most
    }
}
