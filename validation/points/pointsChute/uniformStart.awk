# SPDX-License-Identifier: GPL-3.0-or-later
# The law in one dimension: a layer 0.2 m deep on a base on which nothing slides at 24
# degrees, friction alone, that starts with 0.84 m/s all over its depth. Reads z and
# speed of each point after "time" [s], whose fourth column is the steady speed at the
# surface, and prints what the largest and the mean difference are over it [%].

# Velocities u[1..n] after dt, implicit: the viscosity is that of the latest u
function advance(   f, i, z, rate, inertia, mu, above, below, m)
{
    for (f = 0; f < n; ++f) {
        z = f*dz
        rate = f ? (u[f + 1] - u[f])/dz : u[1]/(dz/2)
        rate = sqrt(rate^2 + 1e-6)
        p = density*g*cos(slope)*(depth - z)
        inertia = rate*0.01*sqrt(2650/p)
        mu = 0.382 + 0.261/(1 + 0.31/inertia)
        nu[f] = mu*p/rate/density
    }
    nu[n] = 0
    for (i = 1; i <= n; ++i) {
        below = dt*nu[i - 1]/dz/(i > 1 ? dz : dz/2)
        above = dt*nu[i]/dz/dz
        b[i] = 1 + below + above
        c[i] = -above
        r[i] = before[i] + dt*g*sin(slope)
        if (i > 1) {
            m = -below/b[i - 1]
            b[i] -= m*c[i - 1]
            r[i] -= m*r[i - 1]
        }
    }
    for (i = n; i > 0; --i)
        u[i] = (r[i] - (i < n ? c[i]*u[i + 1] : 0))/b[i]
}

BEGIN {
    n = 100
    dt = 2e-3
    g = 9.81
    density = 1484
    depth = 0.2
    dz = depth/n
    slope = 24*atan2(0, -1)/180
    for (i = 1; i <= n; ++i) u[i] = 0.84
    for (step = 0; step < time/dt - 0.5; ++step) {
        for (i = 1; i <= n; ++i) before[i] = u[i]
        for (k = 0; k < 3; ++k) advance()
    }
}

{
    i = int($1/dz + 0.5)            # the mean of the cells below and above z
    low = i < 1 ? 0 : u[i > n ? n : i]
    high = u[i < n ? i + 1 : n]
    share = $1/dz + 0.5 - i
    e = 100*($2 - low - share*(high - low))/$4
    s += e
    if (e^2 > most^2) most = e
}

END { printf "%.4g %.4g\n", most < 0 ? -most : most, s/NR }
