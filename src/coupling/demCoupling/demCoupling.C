// SPDX-License-Identifier: GPL-3.0-or-later
// The grains beside the fluid: each stage of their exchange is one call.

#include "demCoupling.H"

#include "Time.H"
#include "activePhysics.H"
#include "couplingChecks.H"
#include "functionObject.H"
#include "granularProperties.H"
#include "keywords.H"
#include "resultsVersion.H"

void Foam::demCoupling::makeTransport(const granularProperties& dict)
{
    relaxationTime_ = dict.relaxationTime();
    if (relaxationTime_ > 0 && relaxationTime_ < clock_->interval())
    {
        FatalIOErrorInFunction(dict)
            << "exchange/relaxationTime is " << relaxationTime_
            << " s, below the exchange interval, " << clock_->interval()
            << " s." << nl << "    Give a longer one, or 0 for the interval."
            << exit(FatalIOError);
    }
    if (relaxationTime_ > 0)
    {
        transport_.reset(new solidTransport(mesh_, *phase_));
    }
}


void Foam::demCoupling::makeForces
(
    const granularProperties& dict,
    const hydrostatics& hydrostatic
)
{
    solids_.reset
    (
        new solidFractionField(*exchange_, keywords::sub(dict, "voidFraction"))
    );
    forces_.reset
    (
        new interphaseForces
        (
            *exchange_,
            *solids_,
            keywords::sub(dict, "interphaseForces"),
            hydrostatic,
            phase_->coarseGraining()
        )
    );

    if (phase_->hasClumps() && forces_->lubricates())
    {
        FatalIOErrorInFunction(dict)
            << "There are clumps of spheres, and interphaseForces/lubrication is on:"
            << " spheres that overlap would each have a film of their own." << nl
            << "    Take lubrication out." << exit(FatalIOError);
    }
}


void Foam::demCoupling::locateFirst()
{
    locateGrains();
    checkGrainsInside(*phase_, *exchange_);

    // In a surge soft grains dent deeper than a packing may
    if (!phase_->restarted() && phase_->hasContactRadius())
    {
        checkGrainsInWalls(*phase_, *exchange_);
    }
}


Foam::demCoupling::demCoupling
(
    const fvMesh& mesh,
    const hydrostatics& hydrostatic,
    const scalarField& water
)
:
    mesh_(mesh),
    nEntered_(0),
    largestWarned_(0)
{
    // On written data grains are read by what needs them
    if (functionObject::postProcess)
    {
        return;
    }

    // A file that exists is read; an error in it is reported
    if (!granularProperties::present(mesh))
    {
        Info<< "No constant/granularProperties: no grains" << nl << endl;
        return;
    }

    const granularProperties dict(mesh);

    phase_ = dict.makePhase(mesh, hydrostatic.g());
    clock_.reset(new exchangeClock(*phase_));
    makeTransport(dict);
    dict.checkSmoothing(*phase_);
    exchange_.reset(new grainExchange(mesh));
    makeForces(dict, hydrostatic);

    locateFirst();
    largestWarned_ = warnOfLargeGrains(*exchange_, largestWarned_);
    makeWaterAtExchange(water);
    findVoidFraction();
    solidBefore_ = solidAfter_;
}


Foam::demCoupling::demCoupling(const fvMesh& mesh, const vector& g)
:
    mesh_(mesh),
    phase_(granularProperties(mesh).makePhase(mesh, g)),
    exchange_(new grainExchange(mesh)),
    clock_(new exchangeClock(*phase_)),
    nEntered_(0),
    largestWarned_(0)
{
    locateFirst();
}


void Foam::demCoupling::writeGrainPhysics() const
{
    dictionary method;
    method.add("resultsVersion", resultsVersion);
    if (transport_)
    {
        method.add("relaxationTime", relaxationTime_);
    }

    Info<< "Results of version " << resultsVersion << nl << endl;
    writeActivePhysics(mesh_, "method", method);
    writeActivePhysics(mesh_, "grains", phase_->activePhysics());
}


void Foam::demCoupling::startAlone() const
{
    Info<< "Grains alone: voidFraction, interphaseForces, exchange/relaxationTime and"
        << " the fields of a fluid are not read" << nl << endl;

    const dictionary& control = mesh_.time().controlDict();
    const scalar deltaT = control.get<scalar>("deltaT");
    const scalar interval = clock_->interval();
    if (mag(deltaT - interval) > exchangeClock::roundOff*interval)
    {
        IOWarningInFunction(control)
            << "deltaT " << deltaT << " s is not used: without a fluid a step is an"
            << " exchange interval, " << interval << " s (" << phase_->stepsPerExchange()
            << " DEM steps of " << phase_->timeStep() << " s)." << endl;
    }

    writeGrainPhysics();

    // Time 0 as they start, for pictures and later evaluation
    if (!phase_->restarted() && mesh_.time().value() < SMALL)
    {
        writeCloud();
    }
}


const Foam::exchangeClock& Foam::demCoupling::clock() const
{
    if (!clock_)
    {
        FatalErrorInFunction
            << "There are no grains, so there is no exchange interval. Name grains in"
            << " constant/granularProperties, or use what needs no exchange."
            << exit(FatalError);
    }
    return *clock_;
}


void Foam::demCoupling::resetSums(const vectorField& U)
{
    clock_->begin();
    startU_ = U;
    sums_.U = vectorField(U.size(), Zero);
    sums_.pressureGradient = sums_.U;
    sums_.viscousForce = sums_.U;
    sums_.rho = scalarField(U.size(), Zero);
    sums_.fromPressure = Zero;
}


void Foam::demCoupling::start(const fluidFields& fluid)
{
    writeActivePhysics(mesh_, "interphaseForces", forces_->activePhysics());
    writeGrainPhysics();
    resetSums(fluid.U);
    clock_->end();

    if (phase_->restarted())
    {
        // Beside the state of the grains, wherever the file handler keeps it
        forces_->readState
        (
            fileHandler().filePath
            (
                mesh_.time().timePath()/granularPhase::stateFolder/"state"
            ).path()
        );
        return;
    }

    warnOfSlowGrains
    (
        *exchange_, *solids_, *forces_, phase_->coarseGraining(), fluid
    );
    forces_->start(fluid, clock_->interval());
    phase_->setFluidForce
    (
        exchange_->toPhase(forces_->force(), phase_->size()),
        exchange_->toPhase(forces_->torque(), phase_->size())
    );
}


void Foam::demCoupling::startEntered
(
    const labelUList& entered,
    const fluidFields& fluid
)
{
    exchange_->locate(*phase_, entered);
    solids_->shareSome();
    forces_->startEntered(fluid, clock_->interval());

    const label n = phase_->size();
    const vectorField newForce(exchange_->toPhase(forces_->force(), n));
    const vectorField newTorque(exchange_->toPhase(forces_->torque(), n));
    vectorField force(phase_->fluidForce());
    vectorField torque(phase_->fluidTorque());

    for (const label i : entered)
    {
        force[i] = newForce[i];
        torque[i] = newTorque[i];
    }
    phase_->setFluidForce(force, torque);
}


void Foam::demCoupling::moveGrains(const std::function<fluidFields()>& fluid)
{
    const stageTimes::stage stage(times_, "moveGrains");

    if (!fluid)
    {
        phase_->advance();
        return;
    }

    // It stands still while the grains move
    autoPtr<fluidFields> now;
    phase_->advance
    (
        [&](const labelUList& entered)
        {
            if (returnReduce(entered.size(), sumOp<label>()))
            {
                if (!now)
                {
                    now.reset(new fluidFields(fluid()));
                }
                startEntered(entered, *now);
            }
        }
    );
}


void Foam::demCoupling::locateGrains()
{
    const stageTimes::stage stage(times_, "locateGrains");
    exchange_->locate(*phase_);

    if (forces_ && phase_->nEntered() > nEntered_)
    {
        nEntered_ = phase_->nEntered();
        largestWarned_ = warnOfLargeGrains(*exchange_, largestWarned_);
    }
}


void Foam::demCoupling::prepareForces(const fluidFields& fluid)
{
    const stageTimes::stage stage(times_, "prepareForces");
    resetSums(fluid.U);
    forces_->prepare(fluid, clock_->interval());
}


void Foam::demCoupling::addFluidStep
(
    const vectorField& U,
    const scalarField& rho,
    const surfaceScalarField& netForce,
    const vectorField& pressureForce,
    const vectorField& viscousForce,
    const scalar dt
)
{
    if (!hasGrains())
    {
        return;
    }

    const vectorField net(forces_->division().atCells(netForce));

    clock_->add(dt);
    sums_.U += dt*U;
    sums_.rho += dt*rho;
    sums_.pressureGradient += dt*(forces_->hydrostatic().gradient(rho) - net);
    if (viscousForce.size())
    {
        sums_.viscousForce += dt*viscousForce;
    }

    // Cell by cell: the sums of both are large
    forAll(net, cell)
    {
        sums_.fromPressure +=
            dt*mesh_.V()[cell]*(pressureForce[cell] - net[cell]);
    }
}


void Foam::demCoupling::setGrainForces(const vectorField& U)
{
    const stageTimes::stage stage(times_, "setGrainForces");

    const scalar elapsed = clock_->elapsed();
    const fluidMeans means
    {
        sums_.U/elapsed,
        (U - startU_)/elapsed,
        sums_.pressureGradient/elapsed,
        sums_.viscousForce/elapsed,
        sums_.rho/elapsed,
        sums_.fromPressure/elapsed
    };

    forces_->finish(means);
    phase_->setFluidForce
    (
        exchange_->toPhase(forces_->force(), phase_->size()),
        exchange_->toPhase(forces_->torque(), phase_->size())
    );

    report();
}


void Foam::demCoupling::report() const
{
    Info<< "Grains: " << phase_->nTotal() << " = "
        << returnReduce(exchange_->grains().size(), sumOp<label>())
        << " located + " << exchange_->nOutside() << " outside; entered "
        << phase_->nEntered() << ", left " << phase_->nLeft() << endl;

    if (!forces_)
    {
        return;
    }

    const scalar volume = solids_->mapping().totalVolume();

    Info<< "Exchange: force residual " << forces_->residual()
        << ", volume residual "
        << mag(gSum(solidAfter_*mesh_.V()) - volume)/(volume + VSMALL);
    if (transport_)
    {
        Info<< ", void fraction differs by up to " << lag_;
    }
    Info<< endl;
}
