# SPDX-License-Identifier: GPL-3.0-or-later
# The drag laws as published, apart from the solver's C++, for the validation
# cases of suspensions and packings:
#
#   awk -v d=1e-3 -v rho=1000 -v mu=1e-3 -v rhoS=2650 -v gravity=9.81 \
#       -f dragLaws.awk -f dragBalance.awk -f case.awk
#
# d, rhoS: diameter and density of the grains, rho, mu: density and viscosity
# of the fluid, all in SI. e is the void fraction, U the superficial slip: e times
# the slip between the grains. What the authors call drag differs. Some mean the whole
# force of the fluid less hydrostatic buoyancy; others leave out the gradient of the
# excess pressure, which carries a grain with the share 1 - e of the whole. The laws here
# leave it out, so that the whole force is that of the law over e.

BEGIN { pi = atan2(0, -1) }

function power(x, y) { return x > 0 ? exp(y*log(x)) : 0 }

function volume() { return pi*d^3/6 }

# Schiller & Naumann 1933
function dragCoefficient(Re)
{
    return Re > 1000 ? 0.44 : 24/Re*(1 + 0.15*power(Re, 0.687))
}

# Force on a single sphere in the stream U, C_d at Re [N]
function sphere(U, Re)
{
    return dragCoefficient(Re)*rho*U*U/2*pi*d*d/4
}

function exponentDiFelice(Re)
{
    return 3.7 - 0.65*exp(-(1.5 - log(Re)/log(10))^2/2)
}

# Di Felice 1994: a single sphere in the superficial stream, times e^-beta
function DiFelice(e, U,    Re)
{
    Re = rho*d*U/mu
    return sphere(U, Re)*power(e, -exponentDiFelice(Re))
}

# Eqs 4-7 of the erosion study: stream and Re between the grains, e^(1 - beta)
function asPrinted(e, U,    Re)
{
    Re = rho*d*U/e/mu
    return sphere(U/e, Re)*power(e, 1 - exponentDiFelice(Re))
}

# Whole force on a grain from the pressure gradient that Ergun 1952 measured,
# 150 mu (1 - e)^2 U/(e^3 d^2) + 1.75 rho (1 - e) U^2/(e^3 d), over the grains
# per volume, (1 - e)/V
function ErgunForce(e, U)
{
    return volume()*(150*mu*(1 - e)*U/d^2 + 1.75*rho*U^2/d)/e^3
}

# Gidaspow 1994: Ergun; from 0.8 on Wen & Yu 1966,
# beta = 3/4 C_d e (1 - e) rho slip e^-2.65/d per volume
function Gidaspow(e, U)
{
    if (e < 0.8) return e*ErgunForce(e, U)
    return 3/4*dragCoefficient(rho*d*U/mu)*e*rho*(U/e)^2*power(e, -2.65)/d \
        *volume()
}

# Koch & Hill 2001, Hill, Koch & Ladd 2001: the whole force over that of Stokes
# in the superficial stream, Re with the radius
function KochHill(e, U,    s, Re, F0, F3)
{
    s = 1 - e
    Re = rho*U*d/(2*mu)
    if (s < 0.4)
        F0 = (1 + 3*sqrt(s/2) + (s > 0 ? 135/64*s*log(s) : 0) + 16.14*s) \
            /(1 + 0.681*s - 8.48*s^2 + 8.16*s^3)
    else
        F0 = 10*s/(1 - s)^3
    F3 = 0.0673 + 0.212*s + 0.0232/(1 - s)^5
    return e*3*pi*mu*d*U*(F0 + F3*Re)
}

# Beetstra, van der Hoef & Kuipers 2007: less the pressure gradient's share,
# over Stokes in the superficial stream
function Beetstra(e, U,    s, Re, F)
{
    s = 1 - e
    Re = rho*U*d/mu
    F = 10*s/(1 - s)^2 + (1 - s)^2*(1 + 1.5*sqrt(s)) \
        + 0.413*Re/(24*(1 - s)^2) \
        *(1/(1 - s) + 3*s*(1 - s) + 8.4*power(Re, -0.343)) \
        /(1 + power(10, 3*s)*power(Re, -(1 + 4*s)/2))
    return 3*pi*mu*d*U*F
}
