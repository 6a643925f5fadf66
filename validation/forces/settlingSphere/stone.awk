# SPDX-License-Identifier: GPL-3.0-or-later
# Velocity at which a grain of a given sphericity sinks in still water at last: weight
# against the drag of a law of shape. Variables: d, law and p, the sphericity, below 1.

function log10(x) { return log(x)/log(10) }

# Hoelzer & Sommerfeld (2008), C_d Re/24; a grain in all directions
function HolzerSommerfeld(Re, p)
{
    return (24/sqrt(p) + 3*sqrt(Re)/p^0.75 \
      + 0.42*Re/p*10^(p < 1 ? 0.4*(-log10(p))^0.2 : 0))/24
}

# Ganser (1993), C_d Re/24; a grain in all directions
function Ganser(Re, p,    K1, K2, x)
{
    K1 = sqrt(p)
    K2 = p < 1 ? 10^(1.8148*(-log10(p))^0.5743) : 1
    x = Re*K1*K2
    return K2*Re/24*(24/x*(1 + 0.1118*x^0.6567) + 0.4305/(1 + 3305/x))
}

function overStokes(Re, p)
{
    return law == "Ganser" ? Ganser(Re, p) : HolzerSommerfeld(Re, p)
}

function drag(v,    Re)
{
    Re = d*v/nu
    return 3*pi*rho*nu*d*v*overStokes(Re, p)
}

BEGIN {
    pi = atan2(0, -1)
    rho = 1000
    nu = 1e-6
    weight = (2650 - rho)*pi/6*d^3*9.81

    for (high = 1e-9; drag(high) < weight; high *= 2) ;
    low = high/2
    while (high - low > 1e-13*high)
    {
        v = (low + high)/2
        if (drag(v) < weight) low = v; else high = v
    }
    printf "%.6g\n", v
}
