# SPDX-License-Identifier: GPL-3.0-or-later
# What follows from a named drag law, for the validation cases of suspensions and
# packings. Load it after dragLaws.awk, which has the laws and describes the variables:
#
#   awk -v d=1e-3 ... -f dragLaws.awk -f dragBalance.awk -f case.awk
#
# A law has one of the names
#
#   DiFelice asPrinted Gidaspow KochHill Beetstra Ergun SchillerNaumann

# Force on a grain less the share of the pressure gradient [N]
function drag(law, e, U)
{
    if (law == "DiFelice") return DiFelice(e, U)
    if (law == "asPrinted") return asPrinted(e, U)
    if (law == "Gidaspow") return Gidaspow(e, U)
    if (law == "KochHill") return KochHill(e, U)
    if (law == "Beetstra") return Beetstra(e, U)
    if (law == "Ergun") return e*ErgunForce(e, U)
    if (law == "SchillerNaumann") return sphere(U/e, rho*d*U/e/mu)
    print "dragBalance.awk: there is no law " law > "/dev/stderr"
    exit 1
}

# Gradient of the excess pressure along grains that stand still [Pa/m]
function pressureDrop(law, e, U)
{
    return (1 - e)*drag(law, e, U)/e/volume()
}

function weightUnderWater() { return volume()*(rhoS - rho)*gravity }

# Superficial slip that keeps grains afloat: the speed at which they settle
# where no volume flows on the whole, and that of the water which begins to
# lift a packing. All of the grains' weight is carried by the gradient of the
# excess pressure, (1 - e)(rhoS - rho) g, which acts on the grains with their
# volume; what is left to drag is the share e of the weight [m/s]
function floating(law, e,    low, high, middle, i)
{
    low = -30
    high = 5
    for (i = 0; i < 80; i++)
    {
        middle = (low + high)/2
        if (drag(law, e, exp(middle)) < e*weightUnderWater()) low = middle
        else high = middle
    }
    return exp(middle)
}
