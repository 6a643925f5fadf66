# SPDX-License-Identifier: GPL-3.0-or-later
# Velocity of a sphere that sinks in still water, from its force balance
#
#   (m + C rho V) dv/dt = (m - rho V) g - 3 pi mu d (1 + 0.15 Re^0.687) v
#
# with Schiller & Naumann's drag (C_d = 0.44 above Re 1000), by Runge-Kutta of
# fourth order in steps that are halved until the whole curve is right to 1e-8
# of its last velocity.
#
#   awk -v d=.. -v rhoS=.. [-v rho=1000 -v nu=1e-6 -v g=9.81 -v C=0] \
#       -f forceBalance.awk grain.dat
#
# Reads lines "t z v_z" and tells "t v vReference" (downwards, m/s); the last
# line is "# terminal <velocity that balances the forces> deviation <largest
# |v - vReference| over it>".

function drag(v,    Re)
{
    Re = d*v/nu
    return 3*pi*rho*nu*d*v*(Re > 1000 ? 0.44/24*Re : 1 + 0.15*Re^0.687)
}

function rate(v)
{
    return (weight - drag(v))/mass
}

function step(v, h,    a, b, c)
{
    a = rate(v)
    b = rate(v + h/2*a)
    c = rate(v + h/2*b)
    return v + h/6*(a + 2*b + 2*c + rate(v + h*c))
}

# The whole curve into ref[], each step at most h
function integrate(h,    i, j, m, v, span)
{
    v = 0
    for (i = 1; i <= n; ++i)
    {
        span = t[i] - t[i - 1]
        m = int(span/h) + 1
        for (j = 0; j < m; ++j) v = step(v, span/m)
        ref[i] = v
    }
}

# Where drag and weight are equal, by bisection
function terminal(    low, high, v)
{
    for (high = 1e-9; drag(high) < weight; high *= 2) ;
    low = high/2
    while (high - low > 1e-13*high)
    {
        v = (low + high)/2
        if (drag(v) < weight) low = v; else high = v
    }
    return v
}

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

/^#/ { next }

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
