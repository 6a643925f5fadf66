// SPDX-License-Identifier: GPL-3.0-or-later
// The grains beside the fluid: what is checked before a run.

#include "demCoupling.H"

#include "OStringStream.H"
#include "Time.H"

void Foam::demCoupling::checkRegime()
{
    scalar largest = 0;
    for (const locatedGrain& grain : exchange_->grains())
    {
        largest = max(largest, 2*grain.clumpRadius);
    }
    reduce(largest, maxOp<scalar>());

    const scalar cell = cbrt(gMin(mesh_.V()));

    if (largest > max(cell, warnedOf_))
    {
        warnedOf_ = largest;
        WarningInFunction
            << "Grains of " << largest << " m are larger than the smallest"
            << " cell, " << cell << " m (cube root of its volume)." << nl
            << "    This solver takes the flow around a grain from drag laws"
            << " (unresolved regime) and wants cells of two to three grain"
            << " diameters. Where the flow around each grain is to be"
            << " computed, a resolved method is needed. With smoothing over"
            << " several diameters the run goes on." << nl << endl;
    }
}


void Foam::demCoupling::checkSlowGrains(const fluidFields& fluid) const
{
    if (forces_->activePhysics().subDict("drag").get<word>("model") == "none")
    {
        return;
    }

    const particleMeshMapping& mapping = solids_->mapping();
    scalar most = 0;

    forAll(exchange_->grains(), i)
    {
        const locatedGrain& grain = exchange_->grains()[i];
        const scalar mu = max(fluid.mu[grain.cell], SMALL);
        const scalar rho = fluid.rho[grain.cell];
        const scalar d = 2*grain.clumpRadius/phase_->coarseGraining();
        const scalar cell = cbrt(mesh_.V()[grain.cell]);
        const scalar speed =
            mag(forces_->hydrostatic().g())*sqr(d)/(18*mu)
           *mag(grain.mass/mapping.volumes()[i] - rho);

        // Among others it meets water that they all drag, as drag laws have it;
        // faster ones leave what they have dragged behind
        if
        (
            grain.mobile && solidAfter_[grain.cell] < 0.01
         && rho*speed*cell < mu
        )
        {
            // Stokes flow by the drag on one cell and over a bell, that of its
            // gathering included: README.md of interphaseForces
            const scalar width =
                mapping.ofMomentum().width(mapping.sizeClass(i));
            const scalar size = sqrt(sqr(cell/1.59) + sqr(width/0.40));
            most = max(most, pow3(phase_->coarseGraining())*d/size);
        }
    }
    reduce(most, maxOp<scalar>());

    if (most > 0.02)
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


void Foam::demCoupling::checkInside() const
{
    const label nOutside = exchange_->nOutside();

    if (phase_->restarted() || !nOutside)
    {
        return;
    }

    if (nOutside == phase_->nTotal())
    {
        FatalErrorInFunction
            << "None of the " << nOutside << " grains is in the mesh, "
            << mesh_.bounds() << " m." << nl
            << "    Mesh (blockMeshDict, transformPoints) and grains (initial"
            << " script, packingDict) must both be in metres."
            << exit(FatalError);
    }

    WarningInFunction
        << nOutside << " of " << phase_->nTotal() << " grains are outside of"
        << " the mesh at the start, as they may where an outflow is named:"
        << " nothing of the mesh acts on them." << nl
        << "    If they should be in it, place them there, in metres." << nl
        << endl;
}


void Foam::demCoupling::checkWalls() const
{
    label nIn = 0;
    label deepestId = -1;
    point deepestAt(Zero);
    scalar deepest = 0;

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    for (const locatedGrain& grain : exchange_->grains())
    {
        for (const label f : mesh_.cells()[grain.cell])
        {
            const label patch = mesh_.isInternalFace(f) ? -1 : patches.whichPatch(f);

            if (patch < 0 || !phase_->isWall(patches[patch]))
            {
                continue;
            }

            const vector n(mesh_.faceAreas()[f]/mag(mesh_.faceAreas()[f]));
            const scalar overlap =
                grain.radius + ((grain.position - mesh_.faceCentres()[f]) & n);

            if (overlap > 0.1*grain.radius)
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


Foam::string Foam::demCoupling::writingFault(const Time& runTime) const
{
    const dictionary& control = runTime.controlDict();
    const word writeControl
    (
        control.lookupOrDefault<word>("writeControl", "timeStep")
    );
    const scalar interval = phase_->exchangeInterval();
    OStringStream fault;

    const bool byTime =
        writeControl == "adjustable" || writeControl == "adjustableRunTime"
     || writeControl == "runTime";

    if (!byTime)
    {
        fault
            << "writeControl is " << writeControl
            << ": with grains, results are written at ends of exchange"
            << " intervals (" << interval << " s), where grains and water are"
            << " at the same time." << nl
            << "    Use writeControl adjustableRunTime, and a writeInterval"
            << " that is a whole number of intervals.";
        return fault.str();
    }

    if (control.lookupOrDefault<label>("purgeWrite", 0) == 1)
    {
        fault
            << "purgeWrite 1 removes the last time before the next one is"
            << " complete: a run killed just then has none to go on from." << nl
            << "    Use purgeWrite 2, or more, or 0 to keep all.";
        return fault.str();
    }

    for (const word key : {"writeInterval", "endTime"})
    {
        const scalar value =
            control.get<scalar>(key)
          - (key == word("endTime") ? runTime.startTime().value() : 0);
        const scalar n = value/interval;

        // As far as numbers of four digits can be wrong, but never as a whole
        if (mag(n - std::round(n)) > min(1e-4*max(n, scalar(1)), 0.01))
        {
            fault
                << key << " " << control.get<scalar>(key)
                << " s does not fit the exchange interval of " << interval
                << " s (" << phase_->stepsPerExchange() << " DEM steps of "
                << phase_->timeStep() << " s): it is " << n << " intervals."
                << nl << "    Make it a whole number of them.";
            return fault.str();
        }
    }

    return string();
}


Foam::string Foam::demCoupling::stepFault(const Time& runTime) const
{
    const scalar interval = phase_->exchangeInterval();
    const scalar deltaT = runTime.controlDict().get<scalar>("deltaT");
    const scalar fitting = interval/std::ceil(interval/deltaT*(1 - 1e-6));

    if (mag(fitting - deltaT) <= 1e-6*deltaT)
    {
        return string();
    }

    OStringStream fault;
    fault
        << "deltaT " << deltaT << " s does not fit the exchange interval"
        << " of " << interval << " s: a whole number of"
        << " fluid steps would be " << fitting << " s long." << nl
        << "    Give that as deltaT, or adjustTimeStep yes.";

    return fault.str();
}


void Foam::demCoupling::checkTimes
(
    const Time& runTime,
    const bool adjustTimeStep
) const
{
    if (!hasGrains())
    {
        return;
    }

    string fault(writingFault(runTime));
    if (fault.empty() && !adjustTimeStep)
    {
        fault = stepFault(runTime);
    }

    if (fault.size())
    {
        FatalIOErrorInFunction(runTime.controlDict())
            << fault.c_str() << exit(FatalIOError);
    }
}


void Foam::demCoupling::warnOfChanges
(
    const Time& runTime,
    const bool adjustTimeStep
)
{
    const string writing(writingFault(runTime));
    const string step(adjustTimeStep ? string() : stepFault(runTime));
    const string all(writing + (writing.empty() ? "" : "\n    ") + step);

    if (all != lastFault_ && all.size())
    {
        IOWarningInFunction(runTime.controlDict())
            << all.c_str() << nl
            << "    The run goes on: it writes at the first end of an exchange"
            << " after each time to write, and takes the longest fluid step that"
            << " fits." << endl;
    }
    lastFault_ = all;
}
