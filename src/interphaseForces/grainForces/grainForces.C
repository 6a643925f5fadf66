// SPDX-License-Identifier: GPL-3.0-or-later
// Force and torque on each grain from the fluid around it.

#include "grainForces.H"
#include "rootBetween.H"

namespace
{
    using namespace Foam;

    //- Share of the load that contacts carried, 0 to 1: the contact force
    //  against the direction of the load, by its size
    scalar carried(const vector& contact, const vector& load)
    {
        return min(max(-(contact & load)/(magSqr(load) + VSMALL), 0.0), 1.0);
    }
}


Foam::grainForces::grainForces
(
    const grainExchange& exchange,
    const solidFractionField& solids,
    const dictionary& dict,
    const hydrostatics& hydrostatic,
    const scalar coarseGraining
)
:
    exchange_(exchange),
    solids_(solids),
    mapping_(solids.mapping()),
    hydrostatic_(hydrostatic),
    coarseGraining_(coarseGraining),
    laws_(exchange.mesh(), dict),
    meanVelocity_(exchange, mapping_)
{
    if (coarseGraining_ > 1 && laws_.lubrication.strength() > 0)
    {
        FatalIOErrorInFunction(dict)
            << "lubrication is on and coarseGraining is " << coarseGraining_
            << ": how near to a wall the real grains of a computed one are is not"
            << " known. Take one of them out." << exit(FatalIOError);
    }
}


void Foam::grainForces::setTorque
(
    const label i,
    const grainState& state,
    const scalar interval
)
{
    // The computed grain must get the angular acceleration of the grains it
    // stands for: its moment of inertia is N^5 times theirs
    const locatedGrain& grain = exchange_.grains()[i];
    // A rod has less about its axis than the sphere of its volume
    const scalar r = min(grain.radius, grain.clumpRadius);
    const scalar inertia = grain.mobile ? 0.4*grain.mass*sqr(r) : GREAT;
    const scalar c =
        pow5(coarseGraining_)*laws_.rotationalDragCoefficient(state)
       *grain.share;

    torque_[i] = c/(1 + c*interval/inertia)*state.relativeSpin;
}


inline Foam::vector Foam::grainForces::unsupportedLoad
(
    const locatedGrain& grain,
    const scalar rhoAround,
    const vector& viscousForce,
    const scalar volume,
    const vector& lift
) const
{
    const vector weight(grain.mass*hydrostatic_.g());
    const vector buoyancy
    (
       -laws_.pressureGradient*volume*hydrostatic_.gradient(rhoAround)
    );
    const vector viscous(laws_.viscousForce*volume*viscousForce);
    const vector load(weight + grain.fluidForce);

    return
        weight + buoyancy + viscous + lift
      - carried(grain.totalForce - load, load)*load;
}


inline Foam::grainState Foam::grainForces::stateOf
(
    const label i,
    const fluidAtGrain& fluid,
    const scalar dSauter
) const
{
    const locatedGrain& grain = exchange_.grains()[i];
    const scalar perRho = 1/fluid.rhoOfMomentum;
    const vector vorticity((1/fluid.rhoAround)*fluid.vorticity);
    const vector slip(perRho*fluid.momentum - meanVelocity_[i]);

    return grainState
    {
        2*grain.clumpRadius/coarseGraining_,
        slip,
        0.5*vorticity - grain.angularVelocity,
        vorticity,
        fluid.rho,

        // OpenFOAM's HerschelBulkley has none at all where it rests and has no
        // yield stress; its limit there is nu0 or k, but this only avoids 0/0
        max(fluid.mu, SMALL),
        fluid.voidFraction,
        dSauter/coarseGraining_
    };
}


inline void Foam::grainForces::shearLiquid
(
    const label i,
    grainState& state,
    const fluidAtGrain& fluid,
    const flowAtGrain& flow,
    const scalar interval
) const
{
    const locatedGrain& grain = exchange_.grains()[i];
    const scalar muOfFlow = state.mu;
    if (!grain.mobile)
    {
        state.mu = laws_.shear.mu(muOfFlow, state.rho, state.d, mag(state.slip));
        return;
    }

    const scalar volume = mapping_.volumes()[i];
    const scalar N3 = pow3(coarseGraining_)*grain.share;
    const scalar m =
        grain.mass + laws_.virtualMassCoefficient(state)*state.rho*volume;
    const vector load
    (
        unsupportedLoad(grain, fluid.rhoAround, flow.viscousForce, volume, Zero)
    );
    const scalar momentum = mag(m*state.slip - interval*load);

    // Momentum of the slip at the interval's end, and what drag takes, over what there is
    const auto excess = [&](const scalar slip)
    {
        state.mu = laws_.shear.mu(muOfFlow, state.rho, state.d, slip);
        return (m + N3*laws_.drag->K(state)*interval)*slip - momentum;
    };

    const scalar atRest = laws_.shear.slipAtRest(state.d);
    const scalar unbraked = momentum/m;
    excess(unbraked > atRest ? rootBetween(excess, atRest, unbraked) : atRest);
}


inline Foam::vector Foam::grainForces::shearOfCoarseGrains
(
    const label i,
    const scalar K,
    const scalar m,
    const scalar interval
) const
{
    if (coarseGraining_ == 1)
    {
        return Zero;
    }
    const scalar perGrain = K/sqr(coarseGraining_);
    return
        m/(m + perGrain*interval)*perGrain
       *(meanVelocity_[i] - exchange_.grains()[i].velocity);
}


inline void Foam::grainForces::setForce
(
    const label i,
    const grainState& state,
    const fluidAtGrain& fluid,
    const flowAtGrain& flow,
    const scalar K1,
    const vector& lift1,
    const scalar interval
)
{
    const locatedGrain& grain = exchange_.grains()[i];
    const scalar volume = mapping_.volumes()[i];
    // What the laws give is that of a whole grain
    const scalar N3 = pow3(coarseGraining_)*grain.share;
    const scalar perRho = 1/fluid.rhoAround;
    const vector& v = meanVelocity_[i];
    const vector U(state.slip + v);
    const vector convection(perRho*flow.acceleration);

    const scalar K = N3*K1;
    scalar C = laws_.virtualMassCoefficient(state)*state.rho*volume;
    vector lift(lift1);
    if (laws_.history.isOn())
    {
        C += N3*laws_.history.mass(state);
        lift += laws_.history.force(grain.id, state);
    }
    lift *= N3;

    vector load
    (
        unsupportedLoad
        (
            grain, fluid.rhoAround, flow.viscousForce, volume, lift
        )
    );

    // A grain that nothing moves has no velocity to eliminate
    const scalar m = grain.mobile ? grain.mass : GREAT;
    const scalar M = grain.mobile ? m/(m + C + K*interval) : 1;

    if (wallForce_.size())
    {
        wallForce_[i] = laws_.lubrication.force
        (
            grain.position,
            grain.radius,
            state.mu,
            (m + C)*grain.velocity + interval*(load + K*U + C*convection),
            m + C + K*interval,
            interval
        );
        load += wallForce_[i];
    }

    const scalar drag = M*K;
    const scalar virtualMass = M*C;

    drag_[i] = (1/fluid.rhoOfMomentum)*drag;
    virtualMass_[i] = perRho*virtualMass;
    pressure_[i] =
        (1 - M)*laws_.excessPressure*laws_.pressureGradient*volume;
    explicit_[i] = lift + virtualMass*convection - drag*v + (M - 1)*load;

    explicit_[i] += shearOfCoarseGrains(i, K, m, interval);

    setTorque(i, state, interval);
}


void Foam::grainForces::begin()
{
    const label n = exchange_.grains().size();

    drag_.setSize(n);
    virtualMass_.setSize(n);
    pressure_.setSize(n);
    explicit_.setSize(n);
    wallForce_.setSize(laws_.lubrication.strength() > 0 ? n : 0);
    torque_.setSize(n);

    // One grain for one has its own
    if (coarseGraining_ != 1)
    {
        meanVelocity_.update();
    }
}


Foam::grainForces::surroundings Foam::grainForces::gather
(
    const fluidFields& fluid
) const
{
    return
    {
        laws_.usesSauterDiameter() ? mapping_.sauterDiameter() : scalarField(),
        fluidAround(mapping_, fluid),
        flowAround
        (
            mapping_, laws_, fluid.rho, fluid.convection, fluid.viscousForce
        )
    };
}


Foam::List<Foam::List<Foam::givenByGrain>> Foam::grainForces::prepare
(
    const fluidFields& fluid,
    const scalar interval
)
{
    laws_.history.begin(exchange_.grains(), interval);
    return coefficients(fluid, interval);
}


void Foam::grainForces::addGiven
(
    List<List<givenByGrain>>& sums,
    const label i,
    const fluidAtGrain& fluid,
    const vector& U
) const
{
    givenByGrain gives;
    gives.drag = drag_[i];
    gives.virtualMass = virtualMass_[i];
    gives.pressureByDrag = pressure_[i];
    gives.explicitForce = explicit_[i]/fluid.rhoOfMomentum + drag_[i]*U;
    mapping_.weights().add(sums[mapping_.sizeClass(i)], i, gives);
}


Foam::List<Foam::List<Foam::givenByGrain>> Foam::grainForces::coefficients
(
    const fluidFields& fluid,
    const scalar interval
)
{
    begin();

    const surroundings around(gather(fluid));
    const auto flowOf = [&](const label i)
    {
        return around.flow.size() ? mapping_.mean(around.flow, i) : flowAtGrain();
    };
    const label n = exchange_.grains().size();
    List<List<givenByGrain>> sums
    (
        mapping_.nSizeClasses(),
        mapping_.weights().noSums<givenByGrain>()
    );

    // The data of a block of grains stays in the nearest cache
    List<grainState> states(blockOfGrains);
    List<fluidAtGrain> fluids(blockOfGrains);
    scalarField K(blockOfGrains);
    vectorField lift(blockOfGrains);

    for (label first = 0; first < n; first += blockOfGrains)
    {
        states.setSize(min(n - first, blockOfGrains));

        forAll(states, k)
        {
            const label i = first + k;

            fluids[k] = mapping_.mean(around.fluid, i);
            states[k] =
                stateOf(i, fluids[k], around.dSauter.size() ? around.dSauter[i] : 1);

            if (laws_.shear.isOn() && laws_.drag.valid())
            {
                shearLiquid(i, states[k], fluids[k], flowOf(i), interval);
            }
        }

        laws_.dragCoefficients(states, K);
        laws_.liftForces(states, lift);

        forAll(states, k)
        {
            const label i = first + k;

            setForce(i, states[k], fluids[k], flowOf(i), K[k], lift[k], interval);
            addGiven(sums, i, fluids[k], states[k].slip + meanVelocity_[i]);
        }
    }

    for (List<givenByGrain>& cells : sums)
    {
        mapping_.weights().sumOnOwners(cells);
    }
    return sums;
}
