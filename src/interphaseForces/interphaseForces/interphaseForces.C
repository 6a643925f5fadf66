// SPDX-License-Identifier: GPL-3.0-or-later
// All forces between fluid and grains, and the exchange of their momentum.

#include "interphaseForces.H"

#include "closure.H"

namespace
{
    using namespace Foam;

    //- The settings of a family, with its default law where none is named
    dictionary family
    (
        const dictionary& dict,
        const word& name,
        const word& defaultModel
    )
    {
        dictionary settings(keywords::sub(dict, name));

        if (!settings.found("model"))
        {
            settings.add("model", defaultModel);
        }

        return settings;
    }

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
    const scalar coarseGraining,
    const bool mobile
)
:
    exchange_(exchange),
    porosity_(porosity),
    g_(g),
    coarseGraining_(coarseGraining),
    mobile_(mobile),
    drag_(dragModel::New(family(dict, "drag", "DiFelice"))),
    lift_(liftModel::New(family(dict, "lift", "none"))),
    virtualMass_(virtualMassModel::New(family(dict, "virtualMass", "none"))),
    rotationalDrag_
    (
        rotationalDragModel::New(family(dict, "rotationalDrag", "Dennis"))
    ),
    pressureGradientStrength_
    (
        closure::strength
        (
            keywords::sub(dict, "pressureGradient", {"strength"})
        )
    ),
    viscousForceStrength_
    (
        dict.found("viscousForce")
      ? closure::strength
        (
            keywords::sub(dict, "viscousForce", {"strength"})
        )
      : 0
    ),
    dragCoefficient_(exchange.mesh().nCells(), Zero),
    virtualMassCoefficient_(exchange.mesh().nCells(), Zero),
    pressureShare_(exchange.mesh().nCells(), Zero),
    explicitForce_(exchange.mesh().nCells(), Zero),
    residual_(0)
{
    active_.add("drag", family(dict, "drag", "DiFelice"));
    active_.add("lift", family(dict, "lift", "none"));
    active_.add("virtualMass", family(dict, "virtualMass", "none"));
    active_.add("rotationalDrag", family(dict, "rotationalDrag", "Dennis"));

    dictionary pressureGradient;
    pressureGradient.add("strength", pressureGradientStrength_);
    active_.add("pressureGradient", pressureGradient);

    dictionary viscousForce;
    viscousForce.add("strength", viscousForceStrength_);
    active_.add("viscousForce", viscousForce);

    keywords::check(dict, active_.sortedToc());
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
    const scalar inertia = 0.4*grain.mass*sqr(grain.radius);
    const scalar c =
        pow5(coarseGraining_)*rotationalDrag_->coefficient(state);

    torque_[i] = c/(1 + c*interval/inertia)*state.relativeSpin;
}


void Foam::interphaseForces::prepare
(
    const fluidFields& fluid,
    const scalar interval
)
{
    const List<locatedGrain>& grains = exchange_.grains();
    const label n = grains.size();

    rho_ = fluid.rho;

    // Of the fluid at hand, for the laws
    const scalarField rho(porosity_.local(fluid.rho));
    const scalarField mu(porosity_.local(fluid.mu));
    const scalarField voidFraction(porosity_.local(fluid.voidFraction));

    // Of the fluid around, for what is exchanged
    rhoAround_ = porosity_.gather(rho_);
    const vectorField U
    (
        porosity_.gather(vectorField(rho_*fluid.U))/rhoAround_
    );
    const vectorField vorticity
    (
        porosity_.gather(vectorField(rho_*fluid.vorticity))/rhoAround_
    );
    const scalarField dSauter
    (
        drag_->usesSauterDiameter()
      ? porosity_.sauterDiameter()
      : scalarField(n, 1)
    );

    vectorField convection(n, Zero);
    if (active_.subDict("virtualMass").get<word>("model") != "none")
    {
        convection =
            porosity_.gather(vectorField(rho_*fluid.convection))/rhoAround_;
    }

    vectorField viscousForce(n, Zero);
    if (viscousForceStrength_ > 0)
    {
        viscousForce = viscousForceStrength_*porosity_.gather
        (
            fluid.viscousForce
        );
    }

    drag0_.setSize(n);
    virtualMass0_.setSize(n);
    pressure0_.setSize(n);
    explicit_.setSize(n);
    volume_.setSize(n);
    force_.setSize(n);
    torque_.setSize(n);

    const scalar N3 = pow3(coarseGraining_);

    forAll(grains, i)
    {
        const locatedGrain& grain = grains[i];

        const grainState state
        {
            2*grain.radius/coarseGraining_,
            U[i] - grain.velocity,
            0.5*vorticity[i] - grain.angularVelocity,
            vorticity[i],
            rho[i],
            mu[i],
            voidFraction[i],
            dSauter[i]/coarseGraining_
        };

        volume_[i] = porosity::volume(grain);

        const scalar K = N3*drag_->K(state);
        const scalar C = virtualMass_->coefficient(state)*rho[i]*volume_[i];
        const vector lift(N3*lift_->force(state));

        const vector weight(grain.mass*g_);
        const vector buoyancy
        (
            -pressureGradientStrength_*volume_[i]*rhoAround_[i]*g_
        );
        const vector viscous(volume_[i]*viscousForce[i]);

        const vector load(weight + grain.fluidForce);
        const vector free
        (
            weight + buoyancy + viscous + lift
          - carried(grain.totalForce - load, load)*load
        );

        // A grain that nothing moves has no velocity to eliminate
        const scalar m = mobile_ ? grain.mass : GREAT;
        const scalar M = mobile_ ? m/(m + C + K*interval) : 1;

        drag0_[i] = M*K;
        virtualMass0_[i] = M*C;
        pressure0_[i] = (1 - M)*pressureGradientStrength_*volume_[i];
        explicit_[i] =
            lift + virtualMass0_[i]*convection[i] - drag0_[i]*grain.velocity
          + (M - 1)*free;

        setTorque(i, state, interval);
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
           -pressureGradientStrength_
           *porosity::volume(exchange_.grains()[i])*gradient[i];
    }
}


Foam::vectorField Foam::interphaseForces::excess
(
    const vectorField& pressureGradient
) const
{
    return pressureGradient - rho_*g_;
}


void Foam::interphaseForces::finish(const fluidMeans& means)
{
    const vectorField U
    (
        porosity_.gather(vectorField(rho_*means.U))/rhoAround_
    );
    const vectorField acceleration
    (
        porosity_.gather(vectorField(rho_*means.acceleration))/rhoAround_
    );

    const vectorField excessGradient
    (
        porosity_.gather(excess(means.pressureGradient))
    );
    const vectorField exchanged
    (
        drag0_*U + virtualMass0_*acceleration + pressure0_*excessGradient
      + explicit_
    );

    force_ =
        exchanged
      - pressureGradientStrength_*volume_
       *porosity_.gather(means.pressureGradient);

    if (viscousForceStrength_ > 0)
    {
        force_ +=
            viscousForceStrength_*volume_*porosity_.gather(means.viscousForce);
    }

    sumUp(means, exchanged);
}


void Foam::interphaseForces::sumUp
(
    const fluidMeans& means,
    const vectorField& exchanged
)
{
    const vectorField fluid
    (
        exchange_.mesh().V()
       *(
            dragCoefficient_*means.U
          + virtualMassCoefficient_*means.acceleration
          + pressureShare_*excess(means.pressureGradient)
          + explicitForce_
        )
    );

    residual_ =
        mag(gSum(exchanged) - gSum(fluid))
       /(gSum(mag(exchanged)) + VSMALL);
}
