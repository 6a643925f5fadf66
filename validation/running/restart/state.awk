# SPDX-License-Identifier: GPL-3.0-or-later
# State of all grains of a time folder:
#
#   awk -f state.awk 0.4/lagrangian/grains/{positions,U,mass}
#
# Prints centre of mass x y z [m], kinetic energy of the translation [J] and
# number of grains. Lists may be written as N{value} where all values are equal.

FNR == 1 { file++; inside = 0; n = 0 }

/^[0-9]+\{.*\}$/ {
    split($0, part, /[{}]/)
    for (i = 1; i <= part[1]; i++) take(i, part[2])
    next
}
/^\($/ { inside = 1; next }
/^\)/ { inside = 0 }
inside { take(++n, $0) }

function take(i, line)
{
    gsub(/[()]/, "", line)
    value[file, i] = line
    if (i > most) most = i
}

END {
    for (i = 1; i <= most; i++)
    {
        split(value[1, i], r, " ")
        split(value[2, i], U, " ")
        m = value[3, i]
        M += m
        x += m*r[1]; y += m*r[2]; z += m*r[3]
        E += 0.5*m*(U[1]^2 + U[2]^2 + U[3]^2)
    }
    if (M > 0) printf "%.15g %.15g %.15g %.15g %d\n", x/M, y/M, z/M, E, most
}
