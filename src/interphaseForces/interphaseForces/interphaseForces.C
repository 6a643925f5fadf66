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
    const porosity& porosity,
    const dictionary& dict,
    const vector& g,
    const scalar coarseGraining
)
:
    exchange_(exchange),
    porosity_(porosity),
    g_(g),
    coarseGraining_(coarseGraining),
    laws_(exchange.mesh(), dict),
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
        pow5(coarseGraining_)*laws_.rotationalDrag->coefficient(state);

    torque_[i] = c/(1 + c*interval/inertia)*state.relativeSpin;
}


void Foam::interphaseForces::findMeanVelocity()
{
    const List<locatedGrain>& grains = exchange_.grains();
    scalarField mass(grains.size());
    meanVelocity_.setSize(grains.size());

    forAll(grains, i)
    {
        mass[i] = grains[i].mass;
        meanVelocity_[i] = grains[i].velocity;
    }

    // One grain for one has its own
    if (coarseGraining_ > 1)
    {
        meanVelocity_ =
            porosity_.gather(porosity_.spread(vectorField(mass*meanVelocity_)))
           /porosity_.gather(porosity_.spread(mass));
    }
}


Foam::Field<Foam::fluidAtGrain> Foam::interphaseForces::around
(
    const vectorField& U,
    const vectorField& acceleration,
    const vectorField& pressureGradient,
    const vectorField& viscousForce
) const
{
    Field<fluidAtGrain> cells(U.size(), fluidAtGrain(Zero));

    const auto set = [&](const fluidAtGrain::numbers at, const vectorField& v)
    {
        fluidAtGrain::set(cells, at, porosity_.smoothed(v));
    };

    set(fluidAtGrain::momentum, rho_*U);

    if (pressureGradient.size())
    {
        set(fluidAtGrain::pressureGradient, pressureGradient);
    }

    if (laws_.carriesFluid())
    {
        set(fluidAtGrain::acceleration, rho_*acceleration);
    }

    if (laws_.viscousForce > 0)
    {
        set(fluidAtGrain::viscousForce, viscousForce);
    }

    return cells;
}


Foam::Field<Foam::fluidAtGrain> Foam::interphaseForces::gather
(
    const fluidFields& fluid
) const
{
    Field<fluidAtGrain> cells
    (
        around
        (
            fluid.U,
            fluid.convection,
            vectorField(),
            fluid.viscousForce
        )
    );

    const vectorField vorticity
    (
        porosity_.smoothed(vectorField(rho_*fluid.vorticity))
    );
    const scalarField rhoAround(porosity_.smoothed(rho_));

    forAll(cells, cell)
    {
        // Of the fluid around, for what is exchanged
        cells[cell].set(fluidAtGrain::rhoAround, rhoAround[cell]);
        cells[cell].set(fluidAtGrain::vorticity, vorticity[cell]);

        // Of the fluid at hand, for the laws
        cells[cell].set(fluidAtGrain::rho, fluid.rho[cell]);
        cells[cell].set(fluidAtGrain::mu, fluid.mu[cell]);
        cells[cell].set(fluidAtGrain::voidFraction, fluid.voidFraction[cell]);
    }

    return porosity_.local(cells);
}


Foam::vector Foam::interphaseForces::felt
(
    const vector& gradient,
    const scalar rhoAround
) const
{
    const vector atRest(rhoAround*g_);

    return
        laws_.excessPressure < 1
      ? atRest + laws_.excessPressure*(gradient - atRest)
      : gradient;
}


Foam::vector Foam::interphaseForces::freeLoad
(
    const locatedGrain& grain,
    const fluidAtGrain& fluid,
    const scalar volume,
    const vector& lift
) const
{
    const vector weight(grain.mass*g_);
    const vector buoyancy
    (
       -laws_.pressureGradient*volume
       *fluid.number(fluidAtGrain::rhoAround)*g_
    );
    const vector viscous
    (
        laws_.viscousForce*volume
       *fluid.vectorOf(fluidAtGrain::viscousForce)
    );
    const vector load(weight + grain.fluidForce);

    return
        weight + buoyancy + viscous + lift
      - carried(grain.totalForce - load, load)*load;
}


void Foam::interphaseForces::setForce
(
    const label i,
    const fluidAtGrain& fluid,
    const scalar dSauter,
    const scalar interval
)
{
    const locatedGrain& grain = exchange_.grains()[i];
    const scalar volume = porosity_.volumes()[i];
    const scalar N3 = pow3(coarseGraining_);

    rhoAround_[i] = fluid.number(fluidAtGrain::rhoAround);

    const vector U(fluid.vectorOf(fluidAtGrain::momentum)/rhoAround_[i]);
    const vector vorticity
    (
        fluid.vectorOf(fluidAtGrain::vorticity)/rhoAround_[i]
    );
    const vector convection
    (
        fluid.vectorOf(fluidAtGrain::acceleration)/rhoAround_[i]
    );

    const grainState state
    {
        2*grain.radius/coarseGraining_,
        U - meanVelocity_[i],
        0.5*vorticity - grain.angularVelocity,
        vorticity,
        fluid.number(fluidAtGrain::rho),

        // OpenFOAM's HerschelBulkley has none at all where it rests and has no
        // yield stress; its limit there is nu0 or k, but this only avoids 0/0
        max(fluid.number(fluidAtGrain::mu), SMALL),
        fluid.number(fluidAtGrain::voidFraction),
        dSauter/coarseGraining_
    };

    const scalar K = N3*laws_.drag->K(state);
    const scalar C =
        laws_.virtualMass->coefficient(state)*state.rho*volume
      + N3*laws_.history.mass(state);
    const vector lift
    (
        N3*(laws_.lift->force(state) + laws_.history.force(grain.id, state))
    );
    vector load(freeLoad(grain, fluid, volume, lift));

    // A grain that nothing moves has no velocity to eliminate
    const scalar m = grain.mobile ? grain.mass : GREAT;
    const scalar M = grain.mobile ? m/(m + C + K*interval) : 1;

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

    // Shear moves computed grains past each other N times as fast as real ones
    const scalar K1 = K/sqr(coarseGraining_);
    const scalar drag1 = m/(m + K1*interval)*K1;

    drag0_[i] = M*K;
    virtualMass0_[i] = M*C;
    pressure0_[i] =
        (1 - M)*laws_.excessPressure*laws_.pressureGradient*volume;
    explicit_[i] =
        lift + virtualMass0_[i]*convection - drag0_[i]*meanVelocity_[i]
      + drag1*(meanVelocity_[i] - grain.velocity)
      + (M - 1)*load;

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
    rhoAround_.setSize(n);
    drag0_.setSize(n);
    virtualMass0_.setSize(n);
    pressure0_.setSize(n);
    explicit_.setSize(n);
    wallForce_.setSize(n);
    torque_.setSize(n);
    findMeanVelocity();
    laws_.history.begin(exchange_.grains(), interval);

    const Field<fluidAtGrain> atGrains(gather(fluid));
    const scalarField dSauter
    (
        laws_.drag->usesSauterDiameter()
      ? porosity_.sauterDiameter()
      : scalarField(n, 1)
    );

    for (label i = 0; i < n; ++i)
    {
        setForce(i, atGrains[i], dSauter[i], interval);
    }

    spreadToCells();
}


void Foam::interphaseForces::spreadToCells()
{
    dragCoefficient_ = rho_*porosity_.spread(scalarField(drag0_/rhoAround_));
    virtualMassCoefficient_ =
        rho_*porosity_.spread(scalarField(virtualMass0_/rhoAround_));
    explicitForce_ =
        rho_*porosity_.spread(vectorField(explicit_/rhoAround_));
    pressureShare_ = porosity_.spread(pressure0_);
}


void Foam::interphaseForces::start(const vectorField& pressureGradient)
{
    const vectorField gradient(porosity_.gather(pressureGradient));

    force_.setSize(gradient.size());
    torque_.setSize(gradient.size());
    torque_ = Zero;

    forAll(force_, i)
    {
        force_[i] =
           -laws_.pressureGradient*porosity_.volumes()[i]*gradient[i];
    }
}


void Foam::interphaseForces::finish(const fluidMeans& means)
{
    const Field<fluidAtGrain> atGrains
    (
        porosity_.local
        (
            around
            (
                means.U,
                means.acceleration,
                means.pressureGradient,
                means.viscousForce
            )
        )
    );
    const label n = atGrains.size();

    force_.setSize(n);

    for (label i = 0; i < n; ++i)
    {
        const fluidAtGrain& fluid = atGrains[i];
        const vector gradient(fluid.vectorOf(fluidAtGrain::pressureGradient));

        force_[i] =
            (
                drag0_[i]*fluid.vectorOf(fluidAtGrain::momentum)
              + virtualMass0_[i]*fluid.vectorOf(fluidAtGrain::acceleration)
            )/rhoAround_[i]
          + pressure0_[i]*(gradient - rhoAround_[i]*g_)
          + explicit_[i]
          + porosity_.volumes()[i]
           *(
                laws_.viscousForce
               *fluid.vectorOf(fluidAtGrain::viscousForce)
              - laws_.pressureGradient*felt(gradient, rhoAround_[i])
            );
    }

    sumUp(means);

    // Walls give this one, through the fluid between
    force_ += wallForce_;
}


void Foam::interphaseForces::sumUp(const fluidMeans& means)
{
    const scalarField& volume = exchange_.mesh().V();
    const scalarField& solid = porosity_.solidFraction();
    vector taken(Zero);

    forAll(volume, cell)
    {
        vector density
        (
            dragCoefficient_[cell]*means.U[cell]
          + virtualMassCoefficient_[cell]*means.acceleration[cell]
          + explicitForce_[cell]
          + pressureShare_[cell]
           *(means.pressureGradient[cell] - rho_[cell]*g_)
          - solid[cell]*felt(means.pressureGradient[cell], rho_[cell])
        );

        if (laws_.viscousForce > 0)
        {
            density +=
                laws_.viscousForce*solid[cell]*means.viscousForce[cell];
        }

        taken += volume[cell]*density;
    }
    reduce(taken, sumOp<vector>());

    residual_ = mag(gSum(force_) - taken)/(gSum(mag(force_)) + VSMALL);
}
