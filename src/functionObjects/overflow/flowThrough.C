// SPDX-License-Identifier: GPL-3.0-or-later
// What of grains and liquid lies in a box, and how it moves.

#include "flowThrough.H"

#include "PstreamReduceOps.H"

void Foam::flowThrough::add
(
    const bool isSolid,
    const scalar volume,
    const scalar rho,
    const scalar x,
    const vector& u
)
{
    (isSolid ? solid : liquid) += volume;
    (isSolid ? solidFlow : liquidFlow) += volume*u;
    mass += rho*volume;
    momentum += rho*volume*u;
    massX += rho*volume*x;
}


void Foam::flowThrough::reduceAll()
{
    reduce(solid, sumOp<scalar>());
    reduce(liquid, sumOp<scalar>());
    reduce(solidFlow, sumOp<vector>());
    reduce(liquidFlow, sumOp<vector>());
    reduce(mass, sumOp<scalar>());
    reduce(momentum, sumOp<vector>());
    reduce(massX, sumOp<scalar>());
}


Foam::vector Foam::flowThrough::velocity() const
{
    return mass > VSMALL ? vector(momentum/mass) : vector(Zero);
}


Foam::scalar Foam::flowThrough::x() const
{
    return mass > VSMALL ? massX/mass : 0;
}
