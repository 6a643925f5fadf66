#!/usr/bin/awk -f
# SPDX-License-Identifier: GPL-3.0-or-later
# Run-out and height of the heap beside those measured by Lube et al. 2005:
#
#   deposit.awk -v L0=0.2 -v H=0.4 surgeFront.dat grains.dat
#
# L0 and H: width and height of the column [m].

/^#/ { next }

# Lines of surgeFront.dat: time and front
FILENAME == ARGV[ARGC - 2] { time[++n] = $1; front[n] = $2 }

# The highest grain in each of two strips, two grains wide, at the wall
FILENAME == ARGV[ARGC - 1] && $1 < 4*$4 {
    strip = $1 < 2*$4
    if ($3 + $4/2 > top[strip]) top[strip] = $3 + $4/2
}

END {
    a = H/L0
    runOut = (front[n] - L0)/L0
    height = (top[0] + top[1])/2/L0

    # When the front is nearly there
    for (i = n; i > 1 && front[i] > L0 + 0.95*(front[n] - L0); --i)
        rest = time[i]

    printf "Column %g m wide, %g m high, a = %g\n", L0, H, a
    printf "Run-out over width:  %.2f   (Lube et al.: 1.2 a = %.2f for" \
        " a < 1.8, 1.9 a^(2/3) = %.2f for a > 2.8)\n", \
        runOut, 1.2*a, 1.9*a^(2/3)
    printf "Height over width:   %.2f   (Lube et al.: %.2f)\n", \
        height, a < 1.15 ? a : a^0.4
    printf "Time over sqrt(H/g): %.1f   until 95 %% of the run-out" \
        " (Lube et al.: 3.3 until rest)\n", rest/sqrt(H/9.81)
}
