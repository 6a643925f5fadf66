# SPDX-License-Identifier: GPL-3.0-or-later
# Places of grains, each up to 2 mm from a node of a lattice of 9 mm, as
# commands for LIGGGHTS. The same on every machine and any number of ranks.

function random()
{
    state = (state*16807) % 2147483647
    return 4e-3*(state/2147483647 - 0.5)
}

BEGIN {
    state = 4711
    for (i = 0; i < 13; ++i)
        for (j = 0; j < 11; ++j)
            for (k = 0; k < 8; ++k)
                printf "create_atoms 1 single %.6f %.6f %.6f units box\n",
                    0.006 + 0.009*i + random(),
                    (0.1 + 0.009*j + random()) % 0.1,
                    0.0065 + 0.0095*k + random()
}
