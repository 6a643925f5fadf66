# SPDX-License-Identifier: GPL-3.0-or-later
# How far the velocity of a sphere that sinks in still water is from its force balance,
# which is integrated in steps that are halved until the whole curve is right to 1e-8 of
# its last velocity.
#
#   awk -v d=.. -v rhoS=.. [-v rho=1000 -v nu=1e-6 -v g=9.81 -v C=0] \
#       -f forceBalance.awk -f deviation.awk grain.dat
#
# Reads lines "t z v_z" and prints "t v vReference" (downwards, m/s); the last
# line is "# terminal <velocity that balances the forces> deviation <largest
# |v - vReference| over it>".

function abs(x) { return x < 0 ? -x : x }

BEGIN {
    pi = atan2(0, -1)
    if (rho == "") rho = 1000
    if (nu == "") nu = 1e-6
    if (g == "") g = 9.81
    volume = pi/6*d^3
    weight = (rhoS - rho)*volume*g
    mass = (rhoS + C*rho)*volume
    t[0] = 0
}

# A run that went on after a kill may do again what it had done
/^#/ || $1 <= t[n] { next }

{
    t[++n] = $1
    v[n] = -$3
}

END {
    if (!n) { print "# no grain"; exit 1 }

    h = 0.2*mass/(3*pi*rho*nu*d)
    do
    {
        integrate(h)
        for (i = 1; i <= n; ++i) coarse[i] = ref[i]
        h /= 2
        integrate(h)
        error = 0
        for (i = 1; i <= n; ++i)
            if (abs(ref[i] - coarse[i]) > error) error = abs(ref[i] - coarse[i])
    }
    while (error > 1e-8*ref[n])

    most = 0
    end = terminal()
    for (i = 1; i <= n; ++i)
    {
        printf "%.9g %.9g %.9g\n", t[i], v[i], ref[i]
        if (abs(v[i] - ref[i]) > most) most = abs(v[i] - ref[i])
    }
    printf "# terminal %.9g deviation %.6g\n", end, most/end
}
