# SPDX-License-Identifier: GPL-3.0-or-later
# How near the runs of table.csv come to the paper's:
#
#   awk -v enough=9 -v rows="rows..." -v on=-slice -v matrix=FILE -f statistics.awk table.csv
#
# Tells lines "check,quantity,value,wanted,unit" for result.csv and writes the
# correlation matrix; correlations only of "enough" runs, since with few of them mass,
# diameter and solid fraction rise together. "rows" of the same run with other seeds of
# the packing, if there are any, give the intervals of the rank correlations; "on" is
# -slice if they are of slices. Each number is also compared as if the paper's V were
# the void fraction, see README.md.

function abs(x) { return x < 0 ? -x : x }

function mean(x, n,    i, sum)
{
    for (i = 1; i <= n; i++) sum += x[i]
    return sum/n
}

# Correlation of x and y (Pearson)
function correlation(x, y, n,    i, mx, my, xy, xx, yy)
{
    mx = mean(x, n); my = mean(y, n)
    for (i = 1; i <= n; i++)
    {
        xy += (x[i] - mx)*(y[i] - my)
        xx += (x[i] - mx)^2
        yy += (y[i] - my)^2
    }
    return xx > 0 && yy > 0 ? xy/sqrt(xx*yy) : 0
}

# Ranks of x; equal values share the mean of theirs
function rank(x, n, result,    i, k)
{
    for (i = 1; i <= n; i++)
    {
        result[i] = 0.5
        for (k = 1; k <= n; k++)
            result[i] += x[k] < x[i] ? 1 : x[k] == x[i] ? 0.5 : 0
    }
}

# Rank correlation (Spearman)
function rankCorrelation(x, y, n,    rx, ry)
{
    rank(x, n, rx); rank(y, n, ry)
    return correlation(rx, ry, n)
}

# Even chance between 0 and 1 by the generator of Park and Miller (1988), whose numbers
# are whole and below 2^53: the rand() of each awk is another one
function even()
{
    seed = (16807*seed) % 2147483647
    return seed/2147483647
}

function gauss() { return sqrt(-2*log(even()))*cos(6.283185307*even()) }

# Values of a column, of the paper or ours, for the runs that are done
function take(q, result,    i)
{
    for (i = 1; i <= nDone; i++) result[i] = value[i, q]
}

# Standard deviation of a column between packings, pooled over the runs that were
# repeated with other seeds; -1 without. Sets freedom, its degrees of freedom
function scatter(q,    base, n, m, i, sum)
{
    freedom = 0
    for (base in repeats)
    {
        n = repeats[base]
        if (n < 2) continue
        m = 0
        for (i = 1; i <= n; i++) m += repeated[base, i, q]/n
        for (i = 1; i <= n; i++) sum += (repeated[base, i, q] - m)^2
        freedom += n - 1
    }
    return freedom ? sqrt(sum/freedom) : -1
}

function atMostOne(x) { return x > 1 ? 1 : x < -1 ? -1 : x }

# The interval that holds the rank correlation with 90 %, as far as the chance of the
# packings goes. Our numbers have the scatter of one packing already, and one drawn
# on top takes the correlation down once more: by how much the draws miss rho, rho
# misses what it would be without. So they are put on its other side, which is the
# basic bootstrap, and cut at 1, the most that there is
function interval(x, y, s, rho,    draw, i, k, z, drawn, sorted, nDraws)
{
    nDraws = 400
    seed = 12345
    for (draw = 1; draw <= nDraws; draw++)
    {
        for (i = 1; i <= nDone; i++) z[i] = x[i] + s*gauss()
        drawn = rankCorrelation(z, y, nDone)
        for (k = draw; k > 1 && sorted[k - 1] > drawn; k--)
            sorted[k] = sorted[k - 1]
        sorted[k] = drawn
    }
    return sprintf("%.2f to %.2f", \
        atMostOne(2*rho - sorted[int(0.95*nDraws)]), \
        atMostOne(2*rho - sorted[int(0.05*nDraws)]))
}

function tell(check, quantity, number, wanted, unit)
{
    printf "%s,%s,%s,%s,%s\n", nDone == nRuns ? check : "reported", quantity, \
        number, wanted, unit
}

# Runs that lack a number, since they were done before it was read
function lacking(q,    i, n)
{
    for (i = 1; i <= nDone; i++) n += value[i, q] == ""
    return n + 0
}

function compare(q, bound,    i, x, y, all, off, constant, s, rho, m)
{
    if (lacking(q))
    {
        tell("reported", q " - runs without it", lacking(q), "", "")
        return
    }
    take(q, x); take(q "Paper", y)
    for (i = 1; i <= nRuns; i++) all[i] = whole[i, q "Paper"]
    m = mean(all, nRuns)
    for (i = 1; i <= nDone; i++)
    {
        constant += 100*abs(m/y[i] - 1)/nDone
        off += 100*abs(x[i]/y[i] - 1)/nDone
    }

    tell(bound ? "atMost" : "reported", q " - mean absolute difference", \
        sprintf("%.3g", off), bound ? bound : "", "%")
    tell("reported", q " - that of the paper's mean for every run", \
        sprintf("%.3g", constant), "", "%")
    tell("reported", q " - skill over that constant", \
        sprintf("%.2f", 1 - off/constant), "", "")
    if (nDone < enough) return
    rho = rankCorrelation(x, y, nDone)
    s = scatter(q)
    tell(bound ? "atLeast" : "reported", q " - rank correlation", \
        sprintf("%.3f", rho), bound ? 0.85 : "", "")
    if (s >= 0)
    {
        tell("reported", q " - scatter between packings" ofSlices, \
            sprintf("%.2g", 100*s/mean(x, nDone)), "", "% of the mean")
        tell("reported", q " - rank correlation without the chance of the packings - 90 %", \
            interval(x, y, s, rho), "", "")
    }
}

# The paper's number for the same mass and diameter if its V were the void fraction
function ofVoidFraction(q, i,    k)
{
    for (k = 1; k <= nRuns; k++)
        if (whole[k, "D"] == value[i, "D"] && whole[k, "M"] == value[i, "M"] \
            && abs(whole[k, "V"] - (1 - value[i, "V"])) < 1e-6)
            return whole[k, q "Paper"]
}

function compareAsVoidFraction(q,    i, x, y, off)
{
    if (nDone < enough || lacking(q)) return
    take(q, x)
    for (i = 1; i <= nDone; i++)
    {
        y[i] = ofVoidFraction(q, i)
        off += 100*abs(x[i]/y[i] - 1)/nDone
    }
    tell("reported", q " - mean absolute difference if V is the void fraction", \
        sprintf("%.3g", off), "", "%")
    tell("reported", q " - rank correlation if V is the void fraction", \
        sprintf("%.3f", rankCorrelation(x, y, nDone)), "", "")
}

function correlations(    n, name, i, k, x, y, xp, yp, ours, paper, wanted)
{
    n = split("Fr D M V H L Lc", name, " ")
    wanted["D H"]; wanted["M L"]; wanted["M Lc"]; wanted["L Lc"]
    print "first,second,ours,paper,difference" > matrix
    for (i = 1; i <= n; i++)
        for (k = 1; k <= n; k++)
        {
            take(name[i], x); take(name[k], y)
            take(name[i] "Paper", xp); take(name[k] "Paper", yp)
            ours = correlation(x, y, nDone)
            paper = correlation(xp, yp, nDone)
            printf "%s,%s,%.3f,%.3f,%.3f\n", name[i], name[k], ours, paper, \
                ours - paper > matrix
            if ((name[i] " " name[k]) in wanted)
                tell("near", "correlation " name[i] "-" name[k], \
                    sprintf("%.3f", ours), sprintf("%.3f", paper), "")
        }
}

# Other seeds: <run>-seed2 and so on belong to <run>. A slice of a fifth of the width has
# a fifth of the energy
function readSeeds(    files, n, i, k, line, head, cell, m, base, scale)
{
    n = split(rows, files, " ")
    for (i = 1; i <= n; i++)
    {
        if ((getline line < files[i]) <= 0) continue
        m = split(line, head, ",")
        if ((getline line < files[i]) <= 0) continue
        split(line, cell, ",")
        base = cell[1]
        sub(/-seed[0-9]$/, "", base)
        repeats[base]++
        for (k = 2; k <= m; k++)
        {
            scale = head[k] == "E" && on == "-slice" ? 5 : 1
            repeated[base, repeats[base], head[k]] = scale*cell[k]
        }
    }
}

BEGIN { FS = ","; ofSlices = on == "-slice" ? " of slices" : ""; readSeeds() }

NR == 1 {
    for (i = 1; i <= NF; i++) name[i] = $i
    next
}

{
    nRuns++
    done = $2 == "done"
    nDone += done
    for (i = 3; i <= NF; i++)
    {
        whole[nRuns, name[i]] = $i
        if (done) value[nDone, name[i]] = $i
    }
    if (done)
        for (i = 3; i <= 5; i++) value[nDone, name[i] "Paper"] = $i
}

END {
    tell("reported", "runs in the table", nDone " of " nRuns, "", "")
    if (!nDone) exit
    if (nDone >= enough && scatter("H") >= 0)
        tell("reported", "degrees of freedom of the scatter between packings" ofSlices, \
            freedom, "", "")
    compare("H", 5); compare("L", 5); compare("Lc", 5); compare("U", 8)
    compare("h", 0); compare("Fr", 0); compare("Ue", 0); compare("E", 0)
    n = split("H L Lc U Ue h", quantity, " ")
    for (i = 1; i <= n; i++) compareAsVoidFraction(quantity[i])
    if (nDone >= enough) correlations()
}
