# SPDX-License-Identifier: GPL-3.0-or-later
# The rows of runs as tables of numbers for misfitCalibrate, and what they are to come to:
#
#   awk -v to=design -f design/choose.awk design/choosing paper.csv rows...
#
# Writes chutes.csv (H, L, L_c of runs of the chute), heads.csv (of those that have them:
# the bed's velocity at the end, U and h where heads take shape), flume.csv (the bare
# flume), and beside them the targets of the three rows that choose and the conditions of
# the 24 that judge. The numbers of a run and what is varied in it are read from its name.

BEGIN {
    FS = ","
    chutes = to "/chutes.csv"; heads = to "/heads.csv"; flume = to "/flume.csv"
    free = "viscosity,rolling,walls,foot"
    print "D,M,V," free ",H,L,Lc" > chutes
    print "D," free ",Urest,Uhead,hhead" > heads
    print free ",Uhead,hhead,durationHigh" > flume
    print "D,M,V,H,L,Lc" > to "/chuteTargets.csv"
    print "D,M,V" > to "/judged.csv"
    print "D,Urest,Uhead,hhead" > to "/headTargets.csv"
}

NR == FNR {
    if (!/^#/) chooses[$1]
    next
}

FNR == 1 {
    delete c
    for (i = 1; i <= NF; i++) c[$i] = i
    isPaper = $2 == "Fr"
    next
}

# "0.04,115,0.45" of D4M115V45
function conditions(name,    n)
{
    split(name, n, /[DMV-]/)
    D = n[2]/100
    return D "," n[3] "," n[4]/100
}

# The number behind a word of the name
function varied(name, word, unit)
{
    if (!match(name, "-" word "[0-9]+([.][0-9]+)?"))
    {
        print "choose: " name " does not name its " word > "/dev/stderr"
        exit 1
    }
    return substr(name, RSTART + length(word) + 1, RLENGTH - length(word) - 1)*unit
}

isPaper {
    at = conditions($1)
    if ($1 in chooses)
    {
        print at "," $c["H"] "," $c["L"] "," $c["Lc"] > to "/chuteTargets.csv"
        print D ",0.01," $c["U"] "," $c["h"] > to "/headTargets.csv"
    }
    else print at > to "/judged.csv"
    next
}

# Foot of the box: 0 where it is 0.5 m long, 1 where it is 0.5 m high
{
    isFlume = $1 ~ /^flume/
    parameters = varied($1, "viscosity", 1) "," varied($1, "rolling", 0.01) "," \
        varied($1, "walls", 0.01) "," ($1 ~ /-foot50/ ? 0 : 1)
}

isFlume {
    print parameters "," $c["Uhead"] "," $c["hhead"] "," $c["durationHigh"] > flume
    next
}

{
    at = conditions($1)
    print at "," parameters "," $c["H"] "," $c["L"] "," $c["Lc"] > chutes
    if ("Uhead" in c)
        print D "," parameters "," $c["Urest"] "," $c["Uhead"] "," $c["hhead"] > heads
}
