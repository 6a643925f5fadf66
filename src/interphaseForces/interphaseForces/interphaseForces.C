// SPDX-License-Identifier: GPL-3.0-or-later
// All forces between fluid and grains, and the exchange of their momentum.

#include "interphaseForces.H"

Foam::interphaseForces::interphaseForces
(
    const grainExchange& exchange,
    const solidFractionField& solids,
    const dictionary& dict,
    const hydrostatics& hydrostatic,
    const scalar coarseGraining
)
:
    mesh_(exchange.mesh()),
    solids_(solids),
    grains_(exchange, solids, dict, hydrostatic, coarseGraining),
    division_(mesh_),
    dragCoefficient_(mesh_.nCells(), Zero),
    virtualMassCoefficient_(mesh_.nCells(), Zero),
    pressureByDrag_(mesh_.nCells(), Zero),
    explicitForce_(mesh_.nCells(), Zero),
    residual_(0)
{}


void Foam::interphaseForces::prepare
(
    const fluidFields& fluid,
    const scalar interval
)
{
    const grainMeshMapping& mapping = solids_.mapping();
    const List<List<givenByGrain>> sums(grains_.prepare(fluid, interval));
    const auto perVolume = [&](const auto member, const smoothingModel& smoothing)
    {
        List<std::decay_t<decltype(each(sums[0], member))>> ofClasses(sums.size());
        forAll(sums, k)
        {
            ofClasses[k] = each(sums[k], member);
        }
        return mapping.perVolume(ofClasses, smoothing);
    };

    rho_ = fluid.rho;
    dragCoefficient_ =
        rho_*perVolume(&givenByGrain::drag, mapping.ofMomentum());
    virtualMassCoefficient_ =
        rho_*perVolume(&givenByGrain::virtualMass, mapping.ofVolume());
    explicitForce_ =
        rho_*perVolume(&givenByGrain::explicitForce, mapping.ofMomentum());
    explicitForce_ -= dragCoefficient_*fluid.U;
    pressureByDrag_ =
        perVolume(&givenByGrain::pressureByDrag, mapping.ofVolume());
}


void Foam::interphaseForces::finish(const fluidMeans& means)
{
    Tuple2<vector, scalar> onGrains(grains_.finish(means, rho_));
    vector fromFluid(takenFromFluid(means));

    reduce(fromFluid, sumOp<vector>());
    reduce(onGrains.first(), sumOp<vector>());
    reduce(onGrains.second(), sumOp<scalar>());

    residual_ = mag(onGrains.first() - fromFluid)/(onGrains.second() + VSMALL);
}


Foam::vector Foam::interphaseForces::takenFromFluid
(
    const fluidMeans& means
) const
{
    const scalarField& volume = mesh_.V();
    const scalarField& solid = solids_.solidFraction();
    const scalar viscous = viscousForceStrength();
    vector taken(-means.fromPressure);

    forAll(volume, cell)
    {
        vector density
        (
            dragCoefficient_[cell]*means.U[cell]
          + virtualMassCoefficient_[cell]*means.acceleration[cell]
          + explicitForce_[cell]
          - solid[cell]*hydrostatic().gradient(means.rho[cell])
        );

        if (viscous > 0)
        {
            density += viscous*solid[cell]*means.viscousForce[cell];
        }

        taken += volume[cell]*density;
    }

    return taken;
}
