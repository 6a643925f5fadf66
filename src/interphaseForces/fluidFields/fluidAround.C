// SPDX-License-Identifier: GPL-3.0-or-later
// The fluid's cell values as grains take them.

#include "fluidAround.H"
#include "closuresInUse.H"
#include "particleMeshMapping.H"

Foam::List<Foam::fluidAtGrain> Foam::fluidAround
(
    const particleMeshMapping& mapping,
    const fluidFields& fluid
)
{
    List<fluidAtGrain> cells(fluid.rho.size());

    const smoothingModel& ofVolume = mapping.ofVolume();
    const smoothingModel& ofMomentum = mapping.ofMomentum();

    // Of the fluid around, for what is exchanged
    const scalarField rhoAround(mapping.smoothed(fluid.rho, ofVolume));
    setEach(cells, &fluidAtGrain::rhoAround, rhoAround);
    setEach
    (
        cells,
        &fluidAtGrain::rhoOfMomentum,
        &ofMomentum == &ofVolume
      ? rhoAround : mapping.smoothed(fluid.rho, ofMomentum)
    );
    setEach
    (
        cells,
        &fluidAtGrain::momentum,
        mapping.smoothed(vectorField(fluid.rho*fluid.U), ofMomentum)
    );
    setEach
    (
        cells,
        &fluidAtGrain::vorticity,
        mapping.smoothed(vectorField(fluid.rho*fluid.vorticity), ofVolume)
    );

    // Of the fluid at hand, for the laws
    setEach(cells, &fluidAtGrain::rho, fluid.rho);
    setEach(cells, &fluidAtGrain::mu, fluid.mu);
    setEach(cells, &fluidAtGrain::voidFraction, fluid.voidFraction);

    return mapping.weights().reached(std::move(cells));
}


Foam::List<Foam::meanAtGrain> Foam::meansAround
(
    const particleMeshMapping& mapping,
    const fluidMeans& means,
    const scalarField& rho
)
{
    List<meanAtGrain> cells(rho.size());

    setEach
    (
        cells,
        &meanAtGrain::rhoAround,
        mapping.smoothed(means.rho, mapping.ofVolume())
    );
    setEach
    (
        cells,
        &meanAtGrain::momentum,
        mapping.smoothed(vectorField(rho*means.U), mapping.ofMomentum())
    );
    setEach
    (
        cells,
        &meanAtGrain::pressureGradient,
        mapping.smoothed(means.pressureGradient, mapping.ofVolume())
    );

    return mapping.weights().reached(std::move(cells));
}


Foam::List<Foam::flowAtGrain> Foam::flowAround
(
    const particleMeshMapping& mapping,
    const closuresInUse& laws,
    const scalarField& rho,
    const vectorField& acceleration,
    const vectorField& viscousForce
)
{
    const bool carries = laws.carriesFluid();
    const bool shears = laws.viscousForce > 0;

    if (!carries && !shears)
    {
        return List<flowAtGrain>();
    }

    List<flowAtGrain> cells(rho.size());

    if (carries)
    {
        setEach
        (
            cells,
            &flowAtGrain::acceleration,
            mapping.smoothed(vectorField(rho*acceleration), mapping.ofVolume())
        );
    }
    if (shears)
    {
        setEach
        (
            cells,
            &flowAtGrain::viscousForce,
            mapping.smoothed(viscousForce, mapping.ofVolume())
        );
    }

    return mapping.weights().reached(std::move(cells));
}
