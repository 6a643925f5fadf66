# SPDX-License-Identifier: GPL-3.0-or-later
# Effects of mechanisms beside the scatter of packings, as surgeEffects.md defines them,
# from rows of runs <mechanism>-<replicate> and without-<replicate>:
#
#   awk -F, -v noise="30 50 0.003 0.01 0.002" -f effects.awk rows/*.csv
#
# Where vectors names a file, the effects themselves go there, mechanism,sample,effect,
# each over the deviation that chance and noise give it.
#
# noise: of a reading of P, N, L, Q and S, the first letters of the channels. A row has
# <channel>_<sample> behind seconds.

BEGIN { split("P N L Q S", letter, " "); split(noise, sigma, " ") }

FNR == 1 {
    for (before = 1; $before != "seconds" && before < NF; before++) ;
    columns = NF - before
    for (i = 1; i <= columns; i++) heading[i] = $(before + i)
    next
}

{
    what = $1
    sub(/-[0-9]+$/, "", what)
    r = ++runs[what]
    for (i = 1; i <= columns; i++)
    {
        x = $(before + i)
        if (x !~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/)
        {
            print $1 " has no number " heading[i] > "/dev/stderr"
            failed = 1
            exit
        }
        value[what, r, i] = x
        mean[what, i] += x
    }
}

# Of the packings without a mechanism, over the samples of a channel
function scatter(c,    i, r, squares)
{
    for (i = 1; i <= columns; i++)
        if (index(heading[i], c "_") == 1)
            for (r = 1; r <= without; r++)
                squares += (value["without", r, i] - mean["without", i]/without)^2
    return squares/((without - 1)*samples[c])
}

# Sum of the squares of an effect over its variance, less what chance gives
function effect(what, c,    i, x, all, squares)
{
    all = variance[c] + ofReading[c]^2/3
    for (i = 1; i <= columns; i++)
    {
        if (index(heading[i], c "_") != 1) continue
        x = (mean[what, i]/runs[what] - mean["without", i]/without)/sqrt(all)
        squares += x*x
        if (vectors) printf "%s,%s,%.4g\n", what, heading[i], x > vectors
    }
    squares -= samples[c]*variance[c]*(1/runs[what] + 1/without)/all
    return squares > 0 ? squares : 0
}

function line(what,    j, x, all, text)
{
    text = what "," runs[what]
    for (j = 1; j <= channels; j++)
    {
        x = effect(what, channel[j])
        all += x
        text = text sprintf(",%.1f", sqrt(x))
    }
    return text sprintf(",%.1f", sqrt(all))
}

END {
    if (failed) exit 1
    without = runs["without"]
    if (without < 2)
    {
        print "two rows without a mechanism are needed at least" > "/dev/stderr"
        exit 1
    }
    for (i = 1; i <= columns; i++)
    {
        c = substr(heading[i], 1, index(heading[i], "_") - 1)
        if (!samples[c]++) channel[++channels] = c
    }
    printf "mechanism,packings"
    for (j = 1; j <= channels; j++)
    {
        c = channel[j]
        printf ",%s", c
        for (k in letter) if (substr(c, 1, 1) == letter[k]) ofReading[c] = sigma[k]
        variance[c] = scatter(c)
    }
    print ",all"
    fflush()
    for (what in runs) if (what != "without") print line(what) | "sort"
    close("sort")
    printf "scatter of packings over noise,%d", without
    for (j = 1; j <= channels; j++)
        printf ",%.2f", sqrt(variance[channel[j]])/ofReading[channel[j]]
    print ","
}
