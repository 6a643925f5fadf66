// SPDX-License-Identifier: GPL-3.0-or-later
// A continuum of material points in the place of grains: making it and moving it.

#include "materialPointsPhase.H"

#include "Time.H"
#include "addToRunTimeSelectionTable.H"
#include "hasFluid.H"
#include "keywords.H"
#include "materialPointsWalls.H"
#include "periodicity.H"

namespace Foam
{
    defineTypeName(materialPointsPhase);
    addToRunTimeSelectionTable(granularPhase, materialPointsPhase, dictionary);
}


namespace
{

using namespace Foam;

//- The grid over the mesh
pointGrid gridOf(const fvMesh& mesh, const dictionary& dict)
{
    const scalar h = dict.get<scalar>("cellSize");

    if (!(h > 0))
    {
        FatalIOErrorInFunction(dict)
            << "cellSize is " << h << " m; it must be above zero."
            << exit(FatalIOError);
    }

    // Directions that are empty are those of plane strain
    Vector<bool> solved(true, true, true);
    Vector<bool> repeats(periodicity(mesh).along());
    for (direction d = 0; d < 3; ++d)
    {
        solved[d] = mesh.solutionD()[d] == 1;
        repeats[d] = repeats[d] && solved[d];
    }

    return pointGrid(mesh.bounds(), h, solved, repeats);
}


//- The step that intervals count, as the dictionary has it, else the stable one [s]
scalar readTimeStep(const dictionary& dict, const scalar stable)
{
    // Two digits, so that times to write can be whole numbers of intervals
    const scalar unit = std::pow(10.0, std::floor(std::log10(stable)) - 1);
    const scalar step = dict.getOrDefault<scalar>
    (
        "timeStep", unit*std::floor(stable/unit)
    );

    if (!(step > 0))
    {
        FatalIOErrorInFunction(dict)
            << "timeStep is " << step << " s; it must be above zero."
            << exit(FatalIOError);
    }

    return step;
}


//- Points, mass and extent of each body into the log
void printBodies(const materialPointMethod& method)
{
    const pointSet& points = method.points();
    forAll(method.bodies(), body)
    {
        label n = 0;
        scalar mass = 0;
        boundBox extent;
        forAll(points.body, i)
        {
            if (points.body[i] == body)
            {
                ++n;
                mass += points.mass[i];
                extent.add(points.x[i]);
            }
        }
        reduce(n, sumOp<label>());
        reduce(mass, sumOp<scalar>());
        extent.reduce();
        Info<< "    body " << method.bodies()[body] << ": " << n << " points";
        if (n)
        {
            Info<< ", " << mass << " kg, from " << extent.min() << " to "
                << extent.max() << " m";
        }
        Info<< endl;
    }
}


//- Into the log; a warning where a run takes very many
void printSteps(const materialPointsPhase& phase, const Time& time)
{
    // At rest: a flow takes more
    const scalar stable = phase.method().restStep();
    const scalar interval = phase.exchangeInterval();
    const scalar n = std::ceil(interval/stable*(1 - 1e-9));

    Info<< "    " << phase.nTotal() << " points in cells of "
        << phase.method().grid().h() << " m, step " << phase.timeStep()
        << " s, exchange every " << phase.stepsPerExchange() << " steps = "
        << interval << " s";
    if (n > phase.stepsPerExchange())
    {
        Info<< ", in " << n << " steps that are stable";
    }
    Info<< nl << endl;

    const scalar all = n*(time.endTime().value() - time.value())/interval;
    if (all > 1e7)
    {
        WarningInFunction
            << "The points need " << all << " steps until endTime, since waves in"
            << " the stiffest body allow no more than " << stable << " s each."
            << nl << "    Lower its E: waves that are ten times as fast as the flow"
            << " will do. Larger cells allow longer steps, too." << endl;
    }
}

} // End anonymous namespace


Foam::materialPointsPhase::materialPointsPhase
(
    const fvMesh& mesh,
    const dictionary& dict,
    const vector& g,
    const label stepsPerExchange,
    const word& stateName
)
:
    granularPhase(mesh, dict, stepsPerExchange),
    dict_
    (
        keywords::sub
        (
            dict,
            typeName,
            {
                "cellSize", "pointsPerCell", "seed", "transfer", "averaging",
                "densityAveraging", "shifting", "courant", "timeStep",
                "walls", "sideWalls", "outflow", "contact", "bodies"
            }
        )
    ),
    stateName_(stateName),
    g_(g),
    patches_
    (
        keywords::patterns
        (
            keywords::sub
            (
                dict_, "walls", {"patches", "friction", "frictions"}
            ),
            "patches",
            mesh.boundaryMesh().names(),
            wordRes({wordRe(".*", wordRe::REGEX)})
        )
    ),
    method_(gridOf(mesh, dict_), g, dict_),
    gate_(mesh, gateMotion::settings(mesh)),
    now_(mesh.time().value()),
    gateSide_(0),
    restarted_(false),
    timeStep_(0),
    nLeft_(0)
{
    Info<< "Grains: material points" << endl;

    materialPointsWalls::add(method_, mesh.boundaryMesh(), patches_, dict_);
    materialPointsWalls::open(method_, mesh, patches_, dict_);

    const fileName state(stateOnDisk());
    restarted_ = state.size();
    method_.addBodies(dict_, !restarted_);
    materialPointsWalls::setFriction(method_, dict_);
    settling_.reset
    (
        new pointSettling
        (
            method_, dict_.subDict("bodies"), mesh.time().value()
        )
    );

    asGrains_ = pointsAsGrains(method_.bodies(), dict_.subDict("bodies"));

    // Dry, the diameters are of the law alone, and bodies may differ in them
    if (hasFluid(dict))
    {
        const scalar ratio = asGrains_.coarseGraining
        (
            method_, dict_, dict.found("coarseGraining")
        );
        coarseGraining_ = ratio > 0 ? ratio : coarseGraining_;
    }

    timeStep_ = readTimeStep(dict_, method_.restStep());

    if (restarted_)
    {
        readState(state);
    }
    closeGate();
    refresh();

    printBodies(method_);
    printSteps(*this, mesh.time());
}


void Foam::materialPointsPhase::closeGate()
{
    if (!gate_.exists())
    {
        return;
    }

    const bool closed = gate_.travel(now_) <= 0;
    method_.addGate
    (
        gate_.onPlane(), gate_.normal(), gate_.direction(), gate_.edge(now_),
        closed, gateSide_
    );
    Info<< "    gate of constant/slidingGate at " << gate_.onPlane()
        << " m holds points, drawn " << gate_.travel(now_) << " m" << endl;
}


bool Foam::materialPointsPhase::isWall(const polyPatch& patch) const
{
    return materialPointsWalls::isWall(patch, patches_);
}


void Foam::materialPointsPhase::setFluidForce
(
    const UList<vector>& force,
    const UList<vector>&
)
{
    pointSet& points = method_.points();

    forAll(points.force, i)
    {
        points.force[i] = force[i];
    }
}


void Foam::materialPointsPhase::begin()
{
    method_.points().before = method_.points().U;
    method_.walls().resetImpulse();
}


void Foam::materialPointsPhase::move(const scalar time)
{
    scalar remaining = time;
    while (remaining > 1e-9*time)
    {
        // Equal steps, and no short one at the end
        const scalar dt =
            remaining/std::ceil(remaining/method_.stableStep()*(1 - 1e-9));
        if (gate_.exists())
        {
            method_.moveGate(gate_.edge(now_));
        }
        method_.step(dt);
        now_ += dt;
        remaining -= dt;
    }
}


void Foam::materialPointsPhase::end()
{
    settling_->end(exchangeInterval());
    refresh();
}


void Foam::materialPointsPhase::takeSteps(const entryHandler&)
{
    begin();
    move(exchangeInterval());
    end();
}


void Foam::materialPointsPhase::refresh()
{
    const pointSet& p = method_.points();
    asGrains_.refresh(p, exchangeInterval());

    position_.shallowCopy(p.x);
    velocity_.shallowCopy(p.U);
    angularVelocity_.shallowCopy(asGrains_.halfCurl);
    radius_.shallowCopy(asGrains_.radius);
    mass_.shallowCopy(p.mass);
    id_.shallowCopy(p.id);
    totalForce_.shallowCopy(asGrains_.meanForce);
    fluidForce_.shallowCopy(p.force);
    fluidTorque_.shallowCopy(asGrains_.noTorque);

    nLeft_ = returnReduce(method_.nLeft(), sumOp<label>());
}


bool Foam::materialPointsPhase::isOutlet(const polyPatch& patch) const
{
    return
        keywords::patterns(dict_, "outflow", mesh_.boundaryMesh().names())
       .match(patch.name());
}
