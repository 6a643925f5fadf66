// SPDX-License-Identifier: GPL-3.0-or-later
// All forces between fluid and grains, and the exchange of their momentum.

#include "interphaseForces.H"

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


Foam::interphaseForces::interphaseForces
(
    const grainExchange& exchange,
    const voidFraction& pores,
    const dictionary& dict,
    const hydrostatics& rest,
    const scalar coarseGraining
)
:
    exchange_(exchange),
    voidFraction_(pores),
    mapping_(pores.mapping()),
    rest_(rest),
    coarseGraining_(coarseGraining),
    laws_(exchange.mesh(), dict),
    division_(exchange.mesh()),
    dragCoefficient_(exchange.mesh().nCells(), Zero),
    virtualMassCoefficient_(exchange.mesh().nCells(), Zero),
    pressureShare_(exchange.mesh().nCells(), Zero),
    explicitForce_(exchange.mesh().nCells(), Zero),
    residual_(0)
{
    if (coarseGraining_ > 1 && laws_.lubrication.strength() > 0)
    {
        FatalIOErrorInFunction(dict)
            << "lubrication is on and coarseGraining is " << coarseGraining_
            << ": how near to a wall the real grains of a computed one are is not"
            << " known. Take one of them out." << exit(FatalIOError);
    }
}


void Foam::interphaseForces::setTorque
(
    const label i,
    const grainState& state,
    const scalar interval
)
{
    // The computed grain must get the angular acceleration of the grains it
    // stands for: its moment of inertia is N^5 times theirs
    const locatedGrain& grain = exchange_.grains()[i];
    const scalar inertia =
        grain.mobile ? 0.4*grain.mass*sqr(grain.radius) : GREAT;
    const scalar c =
        pow5(coarseGraining_)*laws_.rotationalDragCoefficient(state);

    torque_[i] = c/(1 + c*interval/inertia)*state.relativeSpin;
}


void Foam::interphaseForces::findMeanVelocity()
{
    // One grain for one has its own
    if (coarseGraining_ == 1)
    {
        return;
    }

    const List<locatedGrain>& grains = exchange_.grains();
    scalarField mass(grains.size());
    meanVelocity_.setSize(grains.size());

    forAll(grains, i)
    {
        mass[i] = grains[i].mass;
        meanVelocity_[i] = grains[i].velocity;
    }

    meanVelocity_ =
        mapping_.gather(mapping_.spread(vectorField(mass*meanVelocity_)))
       /mapping_.gather(mapping_.spread(mass));
}


Foam::List<Foam::fluidAtGrain> Foam::interphaseForces::fluidAround
(
    const fluidFields& fluid
) const
{
    List<fluidAtGrain> cells(rho_.size());

    // Of the fluid around, for what is exchanged
    setEach(cells, &fluidAtGrain::rhoAround, rhoSmoothed_);
    setEach
    (
        cells,
        &fluidAtGrain::momentum,
        mapping_.smoothed(vectorField(rho_*fluid.U))
    );
    setEach
    (
        cells,
        &fluidAtGrain::vorticity,
        mapping_.smoothed(vectorField(rho_*fluid.vorticity))
    );

    // Of the fluid at hand, for the laws
    setEach(cells, &fluidAtGrain::rho, fluid.rho);
    setEach(cells, &fluidAtGrain::mu, fluid.mu);
    setEach(cells, &fluidAtGrain::voidFraction, fluid.voidFraction);

    return mapping_.weights().reached(std::move(cells));
}


Foam::List<Foam::meanAtGrain> Foam::interphaseForces::meansAround
(
    const fluidMeans& means
) const
{
    List<meanAtGrain> cells(rho_.size());

    setEach
    (
        cells,
        &meanAtGrain::rhoAround,
        mapping_.smoothed(means.rho)
    );
    setEach
    (
        cells,
        &meanAtGrain::momentum,
        mapping_.smoothed(vectorField(rho_*means.U))
    );
    setEach
    (
        cells,
        &meanAtGrain::pressureGradient,
        mapping_.smoothed(means.pressureGradient)
    );

    return mapping_.weights().reached(std::move(cells));
}


Foam::List<Foam::flowAtGrain> Foam::interphaseForces::flowAround
(
    const vectorField& acceleration,
    const vectorField& viscousForce
) const
{
    const bool carries = laws_.carriesFluid();
    const bool shears = laws_.viscousForce > 0;

    if (!carries && !shears)
    {
        return List<flowAtGrain>();
    }

    List<flowAtGrain> cells(rho_.size());

    if (carries)
    {
        setEach
        (
            cells,
            &flowAtGrain::acceleration,
            mapping_.smoothed(vectorField(rho_*acceleration))
        );
    }
    if (shears)
    {
        setEach
        (
            cells,
            &flowAtGrain::viscousForce,
            mapping_.smoothed(viscousForce)
        );
    }

    return mapping_.weights().reached(std::move(cells));
}


inline Foam::flowAtGrain Foam::interphaseForces::flowAt
(
    const UList<flowAtGrain>& around,
    const label i
) const
{
    return
        around.size() ? mapping_.weights().mean(around, i) : flowAtGrain();
}


inline Foam::vector Foam::interphaseForces::unsupportedLoad
(
    const locatedGrain& grain,
    const scalar rhoAround,
    const vector& viscousForce,
    const scalar volume,
    const vector& lift
) const
{
    const vector weight(grain.mass*rest_.g());
    const vector buoyancy
    (
       -laws_.pressureGradient*volume*rest_.gradient(rhoAround)
    );
    const vector viscous(laws_.viscousForce*volume*viscousForce);
    const vector load(weight + grain.fluidForce);

    return
        weight + buoyancy + viscous + lift
      - carried(grain.totalForce - load, load)*load;
}


inline const Foam::vector& Foam::interphaseForces::meanVelocity
(
    const label i
) const
{
    return
        meanVelocity_.size()
      ? meanVelocity_[i] : exchange_.grains()[i].velocity;
}


inline Foam::grainState Foam::interphaseForces::stateOf
(
    const label i,
    const fluidAtGrain& fluid,
    const scalar dSauter
) const
{
    const locatedGrain& grain = exchange_.grains()[i];
    const scalar perRho = 1/fluid.rhoAround;
    const vector vorticity(perRho*fluid.vorticity);

    return grainState
    {
        2*grain.radius/coarseGraining_,
        perRho*fluid.momentum - meanVelocity(i),
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


inline void Foam::interphaseForces::setForce
(
    const label i,
    const grainState& state,
    const scalar rhoAround,
    const flowAtGrain& flow,
    const scalar K1,
    const vector& lift1,
    const scalar interval
)
{
    const locatedGrain& grain = exchange_.grains()[i];
    const scalar volume = mapping_.volumes()[i];
    const scalar N3 = pow3(coarseGraining_);
    const scalar perRho = 1/rhoAround;
    const vector U(state.slip + meanVelocity(i));
    const vector convection(perRho*flow.acceleration);

    const scalar K = N3*K1;
    scalar C = laws_.virtualMassCoefficient(state)*state.rho*volume;
    vector lift(lift1);
    if (laws_.history.active())
    {
        C += N3*laws_.history.mass(state);
        lift += laws_.history.force(grain.id, state);
    }
    lift *= N3;

    vector load
    (
        unsupportedLoad
        (
            grain,
            rhoAround,
            flow.viscousForce,
            volume,
            lift
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

    drag0_[i] = perRho*drag;
    virtualMass0_[i] = perRho*virtualMass;
    pressure0_[i] =
        (1 - M)*laws_.excessPressure*laws_.pressureGradient*volume;
    explicit_[i] =
        lift + virtualMass*convection - drag*meanVelocity(i) + (M - 1)*load;

    // Shear moves computed grains past each other N times as fast as real ones
    if (meanVelocity_.size())
    {
        const scalar own = K/sqr(coarseGraining_);
        explicit_[i] +=
            m/(m + own*interval)*own*(meanVelocity_[i] - grain.velocity);
    }

    setTorque(i, state, interval);
}


void Foam::interphaseForces::prepare
(
    const fluidFields& fluid,
    const scalar interval
)
{
    const label n = exchange_.grains().size();

    rho_ = fluid.rho;
    rhoSmoothed_ = mapping_.smoothed(rho_);
    drag0_.setSize(n);
    virtualMass0_.setSize(n);
    pressure0_.setSize(n);
    explicit_.setSize(n);
    wallForce_.setSize(laws_.lubrication.strength() > 0 ? n : 0);
    torque_.setSize(n);
    findMeanVelocity();
    laws_.history.begin(exchange_.grains(), interval);

    const scalarField dSauter
    (
        laws_.usesSauterDiameter()
      ? mapping_.sauterDiameter()
      : scalarField()
    );
    const List<fluidAtGrain> around(fluidAround(fluid));
    const List<flowAtGrain> flow
    (
        flowAround(fluid.convection, fluid.viscousForce)
    );
    const cellWeights& weights = mapping_.weights();
    List<givenByGrain> given(weights.noSums<givenByGrain>());

    // What a block of grains is asked for stays in the nearest cache
    List<grainState> states(blockOfGrains);
    scalarField rhoAround(blockOfGrains);
    scalarField K(blockOfGrains);
    vectorField lift(blockOfGrains);

    for (label first = 0; first < n; first += blockOfGrains)
    {
        states.setSize(min(n - first, blockOfGrains));

        forAll(states, k)
        {
            const label i = first + k;
            const fluidAtGrain fluidHere(weights.mean(around, i));

            rhoAround[k] = fluidHere.rhoAround;
            states[k] =
                stateOf(i, fluidHere, dSauter.size() ? dSauter[i] : 1);
        }

        laws_.dragCoefficients(states, K);
        laws_.liftForces(states, lift);

        forAll(states, k)
        {
            const label i = first + k;

            setForce
            (
                i,
                states[k],
                rhoAround[k],
                flowAt(flow, i),
                K[k],
                lift[k],
                interval
            );
            givenByGrain gives;
            gives.drag = drag0_[i];
            gives.virtualMass = virtualMass0_[i];
            gives.pressureShare = pressure0_[i];
            gives.explicitForce = explicit_[i]/rhoAround[k];
            weights.add(given, i, gives);
        }
    }

    weights.bringHome(given);
    setCells(std::move(given));
}


void Foam::interphaseForces::setCells(List<givenByGrain>&& sums)
{
    dragCoefficient_ = rho_*mapping_.perVolume
    (
        each(sums, &givenByGrain::drag)
    );
    virtualMassCoefficient_ = rho_*mapping_.perVolume
    (
        each(sums, &givenByGrain::virtualMass)
    );
    explicitForce_ = rho_*mapping_.perVolume
    (
        each(sums, &givenByGrain::explicitForce)
    );
    pressureShare_ = mapping_.perVolume
    (
        each(sums, &givenByGrain::pressureShare)
    );
}


void Foam::interphaseForces::start(const vectorField& pressureGradient)
{
    const vectorField gradient(mapping_.gather(pressureGradient));

    force_.setSize(gradient.size());
    torque_.setSize(gradient.size());
    torque_ = Zero;

    forAll(force_, i)
    {
        force_[i] =
           -laws_.pressureGradient*mapping_.volumes()[i]*gradient[i];
    }
}


void Foam::interphaseForces::finish(const fluidMeans& means)
{
    const List<meanAtGrain> around(meansAround(means));
    const List<flowAtGrain> flow
    (
        flowAround(means.acceleration, means.viscousForce)
    );
    const cellWeights& weights = mapping_.weights();
    const scalarField& volumes = mapping_.volumes();
    const label n = exchange_.grains().size();

    force_.setSize(n);

    for (label i = 0; i < n; ++i)
    {
        const meanAtGrain fluid(weights.mean(around, i));
        const vector atRest
        (
            rest_.gradient(fluid.rhoAround)
        );
        const vector excess
        (
            fluid.pressureGradient - atRest
        );

        force_[i] =
            drag0_[i]*fluid.momentum
          + pressure0_[i]*excess
          + explicit_[i]
          - laws_.pressureGradient*volumes[i]
           *(atRest + laws_.excessPressure*excess);

        if (flow.size())
        {
            const flowAtGrain here(weights.mean(flow, i));

            force_[i] +=
                virtualMass0_[i]*here.acceleration
              + laws_.viscousForce*volumes[i]
               *here.viscousForce;
        }
    }

    sumUp(means);

    // Walls give this one, through the fluid between
    if (wallForce_.size())
    {
        force_ += wallForce_;
    }
}


void Foam::interphaseForces::sumUp(const fluidMeans& means)
{
    const scalarField& volume = exchange_.mesh().V();
    const scalarField& solid = voidFraction_.solidFraction();
    vector taken(-means.fromPressure);

    forAll(volume, cell)
    {
        vector density
        (
            dragCoefficient_[cell]*means.U[cell]
          + virtualMassCoefficient_[cell]*means.acceleration[cell]
          + explicitForce_[cell]
          - solid[cell]*rest_.gradient(means.rho[cell])
        );

        if (laws_.viscousForce > 0)
        {
            density +=
                laws_.viscousForce*solid[cell]*means.viscousForce[cell];
        }

        taken += volume[cell]*density;
    }
    reduce(taken, sumOp<vector>());

    vector given(Zero);
    scalar size = 0;
    for (const vector& force : force_)
    {
        given += force;
        size += mag(force);
    }
    reduce(given, sumOp<vector>());
    reduce(size, sumOp<scalar>());

    residual_ = mag(given - taken)/(size + VSMALL);
}
