# SPDX-License-Identifier: GPL-3.0-or-later
# Velocity of a sphere released at rest in a uniform stream u, without gravity:
#
#   Stokes   v = u (1 - exp(-t/tau)),     tau = (rhoS + C rho) d^2/(18 mu)
#   Newton   v = u (1 - 1/(1 + k u t)),   k = 0.75 C_d rho/((rhoS + C rho) d)
#
# with C_d = 0.44 and the virtual mass C. Reads "t x v_x", prints "t v vClosed",
# and in its last line the largest deviation over u.

BEGIN {
    rho = 1000
    inertia = 2650 + C*rho
    tau = inertia*d*d/(18*rho*nu)
    k = 0.75*0.44*rho/(inertia*d)
}

/^#/ { next }

{
    closed = law == "Stokes" ? u*(1 - exp(-$1/tau)) : u*(1 - 1/(1 + k*u*$1))
    printf "%.9g %.9g %.9g\n", $1, $3, closed
    deviation = ($3 - closed)/u
    if (deviation < 0) deviation = -deviation
    if (deviation > most) most = deviation
    ++n
}

END {
    if (n) printf "# deviation %.6g\n", most
    else print "# no grain"
}
