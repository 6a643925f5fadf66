// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of grains against the mesh, the fluid and the walls, before a run.

#include "couplingChecks.H"

namespace
{

//- Solid fraction of its cell below which a grain is alone [-]: above it, drag laws of
//  suspensions have the water that the others drag
constexpr Foam::scalar largestAlone = 0.01;

//- In the error of a lone grain's velocity, diameter/sqrt(sqr(cell/1.59) +
//  sqr(width/0.40)) [-]: Stokes flow by the drag on one cell and over a bell, that of its
//  gathering included (README.md of interphaseForces)
constexpr Foam::scalar cellOverSize = 1.59;
constexpr Foam::scalar widthOverSize = 0.40;

//- Error of the velocity from which a run warns [-]: that of good drag laws is larger
constexpr Foam::scalar warnedError = 0.02;

} // End anonymous namespace


Foam::scalar Foam::warnOfLargeGrains
(
    const grainExchange& exchange,
    const scalar largestWarned
)
{
    scalar largest = 0;
    for (const locatedGrain& grain : exchange.grains())
    {
        largest = max(largest, 2*grain.clumpRadius);
    }
    reduce(largest, maxOp<scalar>());

    const scalar cell = cbrt(gMin(exchange.mesh().V()));

    if (largest <= max(cell, largestWarned))
    {
        return largestWarned;
    }

    WarningInFunction
        << "Grains of " << largest << " m are larger than the smallest"
        << " cell, " << cell << " m (cube root of its volume)." << nl
        << "    This solver takes the flow around a grain from drag laws"
        << " (unresolved regime) and wants cells of two to three grain"
        << " diameters. Where the flow around each grain is to be"
        << " computed, a resolved method is needed. With smoothing over"
        << " several diameters the run goes on." << nl << endl;

    return largest;
}


void Foam::warnOfSlowGrains
(
    const grainExchange& exchange,
    const solidFractionField& solids,
    const interphaseForces& forces,
    const scalar coarseGraining,
    const fluidFields& fluid
)
{
    if (!forces.hasDrag())
    {
        return;
    }

    const grainMeshMapping& mapping = solids.mapping();
    const scalarField& solidFraction = solids.solidFraction();
    const scalarField& V = exchange.mesh().V();
    scalar most = 0;

    forAll(exchange.grains(), i)
    {
        const locatedGrain& grain = exchange.grains()[i];
        const scalar mu = max(fluid.mu[grain.cell], SMALL);
        const scalar rho = fluid.rho[grain.cell];
        const scalar d = 2*grain.clumpRadius/coarseGraining;
        const scalar cell = cbrt(V[grain.cell]);
        const scalar speed =
            mag(forces.hydrostatic().g())*sqr(d)/(18*mu)
           *mag(grain.mass/mapping.volumes()[i] - rho);

        // Among others it meets water that they all drag, as drag laws have it;
        // faster ones leave what they have dragged behind
        if
        (
            grain.mobile && solidFraction[grain.cell] < largestAlone
         && rho*speed*cell < mu
        )
        {
            const scalar width =
                mapping.ofMomentum().width(mapping.sizeClass(i));
            const scalar size = sqrt(sqr(cell/cellOverSize) + sqr(width/widthOverSize));
            most = max(most, pow3(coarseGraining)*d/size);
        }
    }
    reduce(most, maxOp<scalar>());

    if (most > warnedError)
    {
        WarningInFunction
            << "Grains that are alone and slow move up to " << 100*most
            << " % too fast against the fluid: each drags along the fluid of its"
            << " cell, which it is given as the fluid around." << nl
            << "    A larger width of voidFraction/smoothing or larger cells reduce"
            << " this. Grains among others are not concerned, nor those that are"
            << " faster than kinematic viscosity over size of a cell." << nl << endl;
    }
}


void Foam::checkGrainsInside
(
    const granularPhase& phase,
    const grainExchange& exchange
)
{
    const label nOutside = exchange.nOutside();

    if (phase.restarted() || !nOutside)
    {
        return;
    }

    if (nOutside == phase.nTotal())
    {
        FatalErrorInFunction
            << "None of the " << nOutside << " grains is in the mesh, "
            << exchange.mesh().bounds() << " m." << nl
            << "    Mesh (blockMeshDict, transformPoints) and grains (initial"
            << " script, packingDict) must both be in metres."
            << exit(FatalError);
    }

    WarningInFunction
        << nOutside << " of " << phase.nTotal() << " grains are outside of"
        << " the mesh at the start, as they may where an outflow is named:"
        << " nothing of the mesh acts on them." << nl
        << "    If they should be in it, place them there, in metres." << nl
        << endl;
}


namespace
{

//- Share of its radius by which a grain may stand in a wall at the start
constexpr Foam::scalar allowedInWall = 0.1;


//- How far a grain reaches into the walls around its cell [m]; 0: not at all
Foam::scalar overlapWithWalls
(
    const Foam::locatedGrain& grain,
    const Foam::granularPhase& phase,
    const Foam::fvMesh& mesh
)
{
    using namespace Foam;

    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    scalar deepest = 0;

    for (const label f : mesh.cells()[grain.cell])
    {
        const label patch = mesh.isInternalFace(f) ? -1 : patches.whichPatch(f);

        if (patch >= 0 && phase.isWall(patches[patch]))
        {
            const vector n(mesh.faceAreas()[f]/mag(mesh.faceAreas()[f]));
            deepest = max
            (
                deepest,
                grain.radius + ((grain.position - mesh.faceCentres()[f]) & n)
            );
        }
    }

    return deepest;
}

} // End anonymous namespace


void Foam::checkGrainsInWalls
(
    const granularPhase& phase,
    const grainExchange& exchange
)
{
    const fvMesh& mesh = exchange.mesh();
    label nIn = 0;
    label deepestId = -1;
    point deepestAt(Zero);
    scalar deepest = 0;

    for (const locatedGrain& grain : exchange.grains())
    {
        const scalar overlap = overlapWithWalls(grain, phase, mesh);

        if (overlap > allowedInWall*grain.radius)
        {
            ++nIn;
            if (overlap > deepest)
            {
                deepest = overlap;
                deepestId = grain.id;
                deepestAt = grain.position;
            }
        }
    }

    const scalar deepestOfAll = returnReduce(deepest, maxOp<scalar>());
    reduce(nIn, sumOp<label>());

    if (deepestOfAll > 0 && deepest == deepestOfAll)
    {
        FatalErrorInFunction
            << "Grains overlap the walls at the start, " << nIn
            << " of them by more than a tenth of their radius." << nl
            << "    The deepest is grain " << deepestId << " at " << deepestAt
            << " m, " << deepest << " m into the wall." << nl
            << "    Move the grains in the initial script, or take the patch"
            << " out of LIGGGHTS/walls/patches in constant/granularProperties."
            << exit(FatalError);
    }
}
