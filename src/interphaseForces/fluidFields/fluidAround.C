// SPDX-License-Identifier: GPL-3.0-or-later
// The fluid's cell values as grains take them.

#include "fluidAround.H"
#include "forceModels.H"
#include "grainMeshMapping.H"

namespace
{

using namespace Foam;

//- For grains of a size class
List<fluidAtGrain> fluidAroundClass
(
    const grainMeshMapping& mapping,
    const fluidFields& fluid,
    const label sizeClass
)
{
    List<fluidAtGrain> cells(fluid.rho.size());

    const smoothingModel& ofVolume = mapping.ofVolume();
    const smoothingModel& ofMomentum = mapping.ofMomentum();
    const auto smoothed = [&](const auto& values, const smoothingModel& smoothing)
    {
        return mapping.smoothed(values, smoothing, sizeClass);
    };

    // Of the fluid around, for what is exchanged
    const scalarField rhoAround(smoothed(fluid.rho, ofVolume));
    setEach(cells, &fluidAtGrain::rhoAround, rhoAround);
    setEach
    (
        cells,
        &fluidAtGrain::rhoOfMomentum,
        &ofMomentum == &ofVolume ? rhoAround : smoothed(fluid.rho, ofMomentum)
    );
    setEach
    (
        cells,
        &fluidAtGrain::momentum,
        smoothed(vectorField(fluid.rho*fluid.U), ofMomentum)
    );
    setEach
    (
        cells,
        &fluidAtGrain::vorticity,
        smoothed(vectorField(fluid.rho*fluid.vorticity), ofVolume)
    );

    // Of the fluid at hand, for the laws
    setEach(cells, &fluidAtGrain::rho, fluid.rho);
    setEach(cells, &fluidAtGrain::mu, fluid.mu);
    setEach(cells, &fluidAtGrain::voidFraction, fluid.voidFraction);

    return mapping.weights().withRemoteCells(std::move(cells));
}


//- For grains of a size class
List<meanAtGrain> meansAroundClass
(
    const grainMeshMapping& mapping,
    const fluidMeans& means,
    const scalarField& rho,
    const label sizeClass
)
{
    List<meanAtGrain> cells(rho.size());
    const auto smoothed = [&](const auto& values, const smoothingModel& smoothing)
    {
        return mapping.smoothed(values, smoothing, sizeClass);
    };

    setEach
    (
        cells, &meanAtGrain::rhoAround, smoothed(means.rho, mapping.ofVolume())
    );
    setEach
    (
        cells,
        &meanAtGrain::momentum,
        smoothed(vectorField(rho*means.U), mapping.ofMomentum())
    );
    setEach
    (
        cells,
        &meanAtGrain::pressureGradient,
        smoothed(means.pressureGradient, mapping.ofVolume())
    );

    return mapping.weights().withRemoteCells(std::move(cells));
}

} // End anonymous namespace


Foam::List<Foam::List<Foam::fluidAtGrain>> Foam::fluidAround
(
    const grainMeshMapping& mapping,
    const fluidFields& fluid
)
{
    List<List<fluidAtGrain>> result(mapping.nSizeClasses());

    forAll(result, k)
    {
        result[k] = fluidAroundClass(mapping, fluid, k);
    }

    return result;
}


Foam::List<Foam::List<Foam::meanAtGrain>> Foam::meansAround
(
    const grainMeshMapping& mapping,
    const fluidMeans& means,
    const scalarField& rho
)
{
    List<List<meanAtGrain>> result(mapping.nSizeClasses());

    forAll(result, k)
    {
        result[k] = meansAroundClass(mapping, means, rho, k);
    }

    return result;
}


Foam::List<Foam::List<Foam::flowAtGrain>> Foam::flowAround
(
    const grainMeshMapping& mapping,
    const forceModels& laws,
    const scalarField& rho,
    const vectorField& acceleration,
    const vectorField& viscousForce
)
{
    const bool carries = laws.carriesFluid();
    const bool shears = laws.viscousForce > 0;

    if (!carries && !shears)
    {
        return List<List<flowAtGrain>>();
    }

    List<List<flowAtGrain>> result(mapping.nSizeClasses());
    const smoothingModel& ofVolume = mapping.ofVolume();

    forAll(result, k)
    {
        List<flowAtGrain> cells(rho.size());

        if (carries)
        {
            setEach
            (
                cells,
                &flowAtGrain::acceleration,
                mapping.smoothed(vectorField(rho*acceleration), ofVolume, k)
            );
        }
        if (shears)
        {
            setEach
            (
                cells,
                &flowAtGrain::viscousForce,
                mapping.smoothed(viscousForce, ofVolume, k)
            );
        }

        result[k] = mapping.weights().withRemoteCells(std::move(cells));
    }

    return result;
}
