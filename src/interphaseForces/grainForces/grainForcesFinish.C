// SPDX-License-Identifier: GPL-3.0-or-later
// Force and torque on each grain: what the fluid did in an interval, and the start.

#include "grainForces.H"

void Foam::grainForces::setBegun
(
    const fluidFields& fluid,
    const scalar interval
)
{
    coefficients(fluid, interval);

    // The pressure is that of rest: at a start p_rgh is mostly not solved for, and the
    // mean of an interval is not known to those that come in
    finish
    (
        fluidMeans
        {
            fluid.U,
            vectorField(fluid.U.size(), Zero),
            hydrostatic_.gradient(fluid.rho),
            fluid.viscousForce,
            fluid.rho,
            Zero
        },
        fluid.rho
    );
}


void Foam::grainForces::start(const fluidFields& fluid, const scalar interval)
{
    laws_.history.begin(exchange_.grains(), interval);
    setBegun(fluid, interval);
}


void Foam::grainForces::startEntered
(
    const fluidFields& fluid,
    const scalar interval
)
{
    laws_.history.setInterval(interval);
    setBegun(fluid, interval);
}


Foam::List<Foam::List<Foam::vector>> Foam::grainForces::loadElsewhere
(
    const fluidMeans& means
) const
{
    const excessVolume& excess = solids_.excess();

    if (!excess.hasMoved())
    {
        return List<List<vector>>();
    }

    const vectorField atRest(hydrostatic_.gradient(means.rho));
    vectorField load
    (
       -laws_.pressureGradient
       *(atRest + laws_.excessPressure*(means.pressureGradient - atRest))
    );
    if (laws_.viscousForce > 0)
    {
        load += laws_.viscousForce*means.viscousForce;
    }
    load = excess.seenFromCells(load) - load;

    List<List<vector>> result(mapping_.nSizeClasses());

    forAll(result, k)
    {
        result[k] = mapping_.weights().withRemoteCells<vector>
        (
            mapping_.smoothed(load, mapping_.ofVolume(), k)
        );
    }

    return result;
}


Foam::Tuple2<Foam::vector, Foam::scalar> Foam::grainForces::finish
(
    const fluidMeans& means,
    const scalarField& rho
)
{
    const List<List<meanAtGrain>> around(meansAround(mapping_, means, rho));
    const List<List<flowAtGrain>> flow = flowAround
    (
        mapping_, laws_, rho, means.acceleration, means.viscousForce
    );
    const List<List<vector>> elsewhere(loadElsewhere(means));
    const scalarField& volumes = mapping_.volumes();
    vector sum(Zero);
    scalar size = 0;

    force_.setSize(exchange_.grains().size());

    forAll(force_, i)
    {
        const meanAtGrain fluid(mapping_.mean(around, i));
        const vector atRest(hydrostatic_.gradient(fluid.rhoAround));
        const vector excess(fluid.pressureGradient - atRest);

        force_[i] =
            drag_[i]*fluid.momentum
          + pressure_[i]*excess
          + explicit_[i]
          - laws_.pressureGradient*volumes[i]
           *(atRest + laws_.excessPressure*excess);

        if (flow.size())
        {
            const flowAtGrain here(mapping_.mean(flow, i));

            force_[i] +=
                virtualMass_[i]*here.acceleration
              + laws_.viscousForce*volumes[i]*here.viscousForce;
        }

        if (elsewhere.size())
        {
            force_[i] += volumes[i]*mapping_.mean(elsewhere, i);
        }

        sum += force_[i];
        size += mag(force_[i]);
    }

    // Walls give this one, through the fluid between
    if (wallForce_.size())
    {
        force_ += wallForce_;
    }

    return {sum, size};
}
