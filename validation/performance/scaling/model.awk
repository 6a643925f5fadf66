# SPDX-License-Identifier: GPL-3.0-or-later
# From what a rank amid 26 others sends (series "amid" of counts.dat) to the shares of
# an exchange with 10,000 grains a rank on 1,000 ranks:
#
#   awk -f model.awk counts.dat        lines "what: value"
#
# Assumed: a message takes 2 us; a rank sends 0.5 GB/s, its share of what its machine
# can; a call of all ranks takes log2(ranks) rounds, each a message and the bytes for
# half of the ranks; each call works 50 ns for each rank on lists of all ranks.
# A grain takes 454 ns in a DEM step, 245 ns in the coupling and 96 ns in the fluid, as
# on one core (../benchmark).

BEGIN {
    ranks = 1000; grains = 10000; steps = 10
    message = 2e-6; speed = 0.5e9; perRank = 50e-9
    rounds = log(ranks)/log(2)
    call = rounds*(message + 4*ranks/2/speed)
}

$1 == "amid" {
    # Each counted exchange has 8 DEM steps. Sums over all ranks go through trees,
    # whose first rank sends to log2(ranks) others
    surface = (grains/($4/$2))^(2/3)
    t = $6*message*rounds/(log($2)/log(2)) + $7*1000*surface/speed + $8*call
    if ($5 == "LIGGGHTS") liggghts += t*steps/8
    else if ($5 == "fluid") fluid += t
    else if ($5 != "write") {
        coupling += t
        work += $8*ranks*perRank
    }
}

END {
    dem = 454e-9*grains*steps
    own = 245e-9*grains
    solution = 96e-9*grains
    total = dem + liggghts + own + coupling + work + solution + fluid
    printf "model - DEM steps [ms]: %.2f\n", 1e3*dem
    printf "model - what LIGGGHTS sends [ms]: %.2f\n", 1e3*liggghts
    printf "model - the coupling's own work [ms]: %.2f\n", 1e3*own
    printf "model - what the coupling sends [ms]: %.2f\n", 1e3*coupling
    printf "model - lists of all ranks [ms]: %.2f\n", 1e3*work
    printf "model - the fluid's own work [ms]: %.2f\n", 1e3*solution
    printf "model - what the fluid sends [ms]: %.2f\n", 1e3*fluid
    printf "model - share of the coupling [%%]: %.1f\n", \
        100*(own + coupling + work)/total
    printf "model - of that what it sends and lists of all ranks [%%]: %.1f\n", \
        100*(coupling + work)/total
}
