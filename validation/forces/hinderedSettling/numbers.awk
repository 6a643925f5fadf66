# SPDX-License-Identifier: GPL-3.0-or-later
# Numbers of hinderedSettling, to be read after dragLaws.awk and dragBalance.awk, with
# d, rho, rhoS and gravity:
#
#   task=box: for the void fraction e, width of the box [m] and jump of the
#       pressure across it [Pa]
#   task=run: for a law and the Reynolds number Re at which a grain settles
#       alone, viscosity of the liquid [m2/s], exchange interval and DEM step
#       [s], DEM steps to an interval, and end [s]
#   task=compare: reads "law Re e U", with the settling speed U [m/s], and
#       prints "law Re e n nLaw |n/nLaw - 1|", where U = U_t e^n
#   task=curve: "e nLaw" for a law and Re

# At given Re, drag scales with the square of the viscosity
function viscosity(law, Re)
{
    mu = 1
    return sqrt(weightUnderWater()/drag(law, 1, Re*mu/(rho*d)))*mu/rho
}

function box(    side)
{
    side = 1.1e-3
    printf "%.12g %.12g\n", volume()/((1 - e)*side*side), \
        -(1 - e)*(rhoS - rho)*gravity*side
}

# An interval is a twentieth of the time in which a grain alone gets its speed
function settings(    nu, interval, steps)
{
    nu = viscosity(law, Re)
    interval = sprintf("%.3g", Re*nu/d/(gravity*(1 - rho/rhoS))/20)
    steps = int(interval/1.2e-5) + 1
    printf "%.12g %.12g %.12g %d %.12g\n", nu, interval, interval/steps, \
        steps, 200*interval
}

# Exponent of the speed U; of the law itself where U is 0
function exponent(law, Re, e, U,    nu)
{
    nu = viscosity(law, Re)
    mu = rho*nu
    return log((U ? U : floating(law, e))/(Re*nu/d))/log(e)
}

function curve(    i)
{
    for (i = 600; i <= 960; i += 5)
        print i/1000, exponent(law, Re, i/1000, 0)
}

function compare(    n, nLaw, deviation)
{
    n = exponent($1, $2, $3, $4)
    nLaw = exponent($1, $2, $3, 0)
    deviation = n/nLaw - 1
    printf "%s %s %s %.6g %.6g %.3g\n", $1, $2, $3, n, nLaw, \
        deviation < 0 ? -deviation : deviation
}

BEGIN {
    if (task == "box") { box(); exit }
    if (task == "run") { settings(); exit }
    if (task == "curve") { curve(); exit }
}

{ compare() }
