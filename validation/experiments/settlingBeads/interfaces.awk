# SPDX-License-Identifier: GPL-3.0-or-later
# Top of the suspension and of the deposit, from the positions and velocities
# of the beads at one time:
#
#   awk -v d=.. -v width=.. -v height=.. -v slow=.. -f interfaces.awk positions U
#
# Spheres are cut exactly into slices two diameters thick. Top of the suspension:
# where the solid fraction falls through 0.25, half of what it was at the start.
# Top of the deposit: up to there the beads sink more slowly than "slow" [m/s].
# Prints: top, deposit [m], speed of the beads between them [m/s], solid fraction
# there and in the deposit; 0 where there is too little of it.

# Volume of a sphere below the height h above its lowest point
function cap(h)
{
    return h <= 0 ? 0 : h >= d ? pi/6*d^3 : pi*h*h*(1.5*d - h)/3
}

# Height between the centres of slices b and b + 1 where x[] is at the level
function between(x, b, level)
{
    return (b + 0.5 + (level - x[b])/(x[b + 1] - x[b]))*thick
}

BEGIN {
    pi = atan2(0, -1)
    thick = 2*d
    nSlices = int(height/thick) + 2
}

FNR == 1 { file++ }

/^\(-?[0-9]/ {
    gsub(/[()]/, "")
    if (file == 1) z[++n] = $3
    else v[++m] = -$3
}

END {
    for (i = 1; i <= n; i++)
    {
        bottom = z[i] - d/2
        for (b = int(bottom/thick); b*thick < bottom + d; b++)
        {
            part = cap((b + 1)*thick - bottom) - cap(b*thick - bottom)
            solid[b] += part/(width*width*thick)
            flux[b] += part*v[i]
        }
    }
    for (b = 0; b < nSlices; b++)
        speed[b] = flux[b]/(solid[b]*width*width*thick + 1e-300)

    for (b = nSlices - 2; b > 0 && solid[b] < 0.25; b--) ;
    top = between(solid, b, 0.25)
    last = b
    for (b = 0; b < last && speed[b + 1] < slow; b++) ;
    deposit = b == last ? top : speed[b] < slow ? between(speed, b, slow) : 0

    # A slice away from the base, and some diameters from either interface
    for (b = 1; b < nSlices; b++)
    {
        middle = (b + 0.5)*thick
        if (middle < deposit - 4*d) { inDeposit += solid[b]; nDeposit++ }
        if (middle > deposit + 4*d && middle < top - 6*d)
        {
            inBulk += solid[b]
            bulkFlux += solid[b]*speed[b]
            nBulk++
        }
    }

    print top, deposit, nBulk ? bulkFlux/inBulk : 0, \
        nBulk ? inBulk/nBulk : 0, nDeposit ? inDeposit/nDeposit : 0
}
