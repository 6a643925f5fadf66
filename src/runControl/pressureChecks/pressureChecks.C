// SPDX-License-Identifier: GPL-3.0-or-later
// Where the pressure of the case at its start would be far from rest.

#include "pressureChecks.H"

namespace
{

using namespace Foam;

//- Head [m] that the denser fluid meets where p_rgh is held on a patch that faces
//  downhill; 0 if it is no higher than a face. A patch beside vertical gravity or
//  square to it is left out: the height that it has been given there may be meant
scalar headAtEnd
(
    const fvPatch& patch,
    const scalarField& gh,
    const vector& g
)
{
    const scalarField slope((patch.nf() & g)/mag(g));
    const scalarField depth(gh/mag(g));
    scalar head = 0;

    forAll(depth, face)
    {
        if
        (
            slope[face] > 0.01 && slope[face] < 0.9
         && depth[face] > std::sqrt(patch.magSf()[face])
        )
        {
            head = max(head, depth[face]);
        }
    }

    return returnReduce(head, maxOp<scalar>());
}


//- Types of patch that take the height along all of gravity, in OpenFOAM v1912 to v2506
const wordHashSet takesHeight
({
    "prghPressure", "prghTotalPressure", "prghTotalHydrostaticPressure",
    "prghPermeableAlphaTotalPressure", "uniformDensityHydrostaticPressure",
    "phaseHydrostaticPressure"
});

}


void Foam::checkPressurePatches
(
    const volScalarField& p_rgh,
    const hydrostatics& hydrostatic
)
{
    for (const fvPatchScalarField& patch : p_rgh.boundaryField())
    {
        if
        (
            hydrostatic.drives()
         && takesHeight.found(patch.type())
        )
        {
            FatalErrorInFunction
                << "Patch " << patch.patch().name() << " of " << p_rgh.name()
                << " is of type " << patch.type() << ", which takes the height"
                << " along all of gravity, while a part of it, "
                << hydrostatic.along() << " m/s2, drives the flow along cyclic"
                << " patches." << nl
                << "    Use fixedValue or totalPressure there."
                << exit(FatalError);
        }
    }
}


void Foam::checkOpenEnds
(
    const volScalarField& p_rgh,
    const volScalarField& gh,
    const volScalarField& rho,
    const hydrostatics& hydrostatic,
    const scalar rhoDense,
    const scalar rhoLight
)
{
    // The level of p is free where one fluid fills the mesh
    if
    (
        hydrostatic.drives() || mag(hydrostatic.normal()) < SMALL
     || gMin(rho.primitiveField()) > 0.5*(rhoDense + rhoLight)
    )
    {
        return;
    }

    const wordHashSet holding
    ({
        "fixedValue",
        "totalPressure",
        "uniformFixedValue",
        "uniformTotalPressure"
    });

    for (label i = 0; i < p_rgh.mesh().boundaryMesh().nNonProcessor(); ++i)
    {
        const fvPatchScalarField& patch = p_rgh.boundaryField()[i];
        const scalarField& ghPatch = gh.boundaryField()[i];

        if (!holding.found(patch.type()))
        {
            continue;
        }

        const scalar head = headAtEnd(patch.patch(), ghPatch, hydrostatic.normal());
        const scalar p0 = rhoLight*gAverage(ghPatch);

        if (head > 0)
        {
            WarningInFunction
                << "Patch " << patch.patch().name() << " of " << p_rgh.name()
                << " is of type " << patch.type() << ". As p_rgh = p - rho g.x,"
                << " the denser fluid meets a head of " << head << " m there,"
                << " and piles up as behind a weir." << nl
                << "    To let it leave, write in " << p_rgh.objectPath()
                << ":  type prghTotalPressure; p0 uniform " << p0
                << "; value uniform 0;  with the pressure of the lighter fluid"
                << " at rest in the middle of the patch." << endl;
        }
    }
}


void Foam::checkHeight
(
    const volScalarField& gh,
    const vector& g,
    const scalar hRef
)
{
    const scalar lowest = gMin(gh.primitiveField());
    const scalar highest = gMax(gh.primitiveField());
    const scalar farthest = max(mag(lowest), mag(highest));
    const scalarField points(g & gh.mesh().points());
    const scalar height = gMax(points) - gMin(points);

    // As gh.H takes hRef: by how much gh changes for each metre. Where gravity points
    // between axes it may change by nothing
    const scalar perMetre = (g & cmptMag(g))/max(mag(g), SMALL);

    if (farthest > 20*height && mag(perMetre) > 0.1*mag(g))
    {
        const scalar better = hRef + 0.5*(lowest + highest)/perMetre;

        WarningInFunction
            << "The mesh is up to " << farthest/mag(g) << " m from where height"
            << " counts as zero, and " << height/mag(g)
            << " m high: p_rgh = p - rho g.x changes by the weight of all that"
            << " height at the water's surface, and the flow may diverge." << nl
            << "    Write constant/hRef, the height of the mesh: dimensions"
            << " [0 1 0 0 0 0 0]; value " << better << "; a p_rgh that patches hold"
            << " counts from there." << nl << endl;
    }
}


void Foam::checkSurfaceAtRefinement
(
    const volScalarField& alpha,
    const vector& g
)
{
    const fvMesh& mesh = alpha.mesh();
    const scalarField& V = mesh.V();
    const auto cut = [&](const label cell)
    {
        return alpha[cell] > 0.01 && alpha[cell] < 0.99;
    };
    label n = 0;
    point where(Zero);

    forAll(mesh.neighbour(), f)
    {
        const label own = mesh.owner()[f];
        const label other = mesh.neighbour()[f];

        const label larger = V[own] > V[other] ? own : other;

        // Graded cells differ in volume as well, but each side is one face
        if
        (
            max(V[own], V[other]) > 3*min(V[own], V[other])
         && mesh.cells()[larger].size() > 6
         && (cut(own) || cut(other))
        )
        {
            where = n++ ? where : mesh.faceCentres()[f];
        }
    }

    const label all = returnReduce(n, sumOp<label>());

    if (all && mag(g) > SMALL)
    {
        reduce(where, maxMagSqrOp<point>());
        WarningInFunction
            << "The surface of the water crosses cells beside refined ones, at "
            << all << " faces, as at " << where << " m. Water at rest may not stay"
            << " so there: within a second air can reach 0.7 m/s, water 0.1." << nl
            << "    Let the level be where cells meet, or let the refinement end"
            << " away from it (see the page of the solver)." << nl << endl;
    }
}
