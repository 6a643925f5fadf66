# SPDX-License-Identifier: GPL-3.0-or-later
# A bed of grains in layers, and what a drag law predicts for it; to be loaded after
# dragLaws.awk and dragBalance.awk. Reads the positions of the grains as the solver
# writes them.
#
# Given are d, rho, rhoS, mu, gravity; area, floor and top of the column, nLayers
# in it; lower and upper, the layers in whose middle the pressure is taken; the
# width over which the solver smooths, in diameters; a law. Prints
#
#   task=pressure: difference of pressure between the two at the flow U [Pa]
#   task=fromFloor: the same from the floor to the middle of the upper, the lower
#     being the first, and U the velocity between its grains
#   task=lifting: flow at which that difference carries the grains between [m/s]
#   task=weight: difference of pressure that carries them [Pa]
#   task=voidFraction: mean between the two

BEGIN { dz = (top - floor)/nLayers }

# Volume of a grain at height z that lies below a plane
function below(plane, z,    h)
{
    h = plane - z + d/2
    return h <= 0 ? 0 : h >= d ? volume() : pi*h*h*(3*d/2 - h)/3
}

/^\(.* .* .*\)/ {
    sub(/\)/, "", $3)
    for (i = 0; i < nLayers; i++)
        solid[i] += (below(floor + (i + 1)*dz, $3) - below(floor + i*dz, $3)) \
            /(area*dz)
}

# Diffusion until a point has become exp(-r^2/b^2), b = width d
function smooth(    i, k, nSteps, step, flux)
{
    nSteps = 200
    step = (width*d)^2/4/nSteps/dz^2
    for (k = 0; k < nSteps; k++)
    {
        for (i = 1; i < nLayers; i++)
            flux[i] = step*(solid[i] - solid[i - 1])
        for (i = 0; i < nLayers; i++)
            solid[i] += flux[i + 1] - flux[i]
    }
}

# Sum over the layers between of what a metre of each has
function sum(what, U,    i, total)
{
    for (i = lower; i <= upper; i++)
        total += dz*(i == lower || i == upper ? 0.5 : 1) \
            *(what == "solid" ? solid[i] : pressureDrop(law, 1 - solid[i], U))
    return total
}

function fromFloor(flow)
{
    return sum("pressure", flow) + dz/2*pressureDrop(law, 1 - solid[0], flow)
}

# That share of the weight under water counts
function weight() { return share*sum("solid")*(rhoS - rho)*gravity }

function lifting(    low, high, middle, i)
{
    low = -15
    high = 5
    for (i = 0; i < 60; i++)
    {
        middle = (low + high)/2
        if (sum("pressure", exp(middle)) < weight()) low = middle
        else high = middle
    }
    return exp(middle)
}

END {
    smooth()
    printf "%.6g", task == "pressure" ? sum("pressure", U) \
        : task == "fromFloor" ? fromFloor((1 - solid[0])*U) \
        : task == "lifting" ? lifting() \
        : task == "weight" ? weight() : 1 - sum("solid")/(dz*(upper - lower))
}
