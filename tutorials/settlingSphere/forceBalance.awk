# SPDX-License-Identifier: GPL-3.0-or-later
# Velocity of a sphere that sinks in still water, from its force balance
#
#   (m + C rho V) dv/dt = (m - rho V) g - 3 pi mu d (1 + 0.15 Re^0.687) v
#
# with Schiller & Naumann's drag (C_d = 0.44 above Re 1000), by Runge-Kutta of
# fourth order. Before deviation.awk, which sets the numbers and compares.

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
