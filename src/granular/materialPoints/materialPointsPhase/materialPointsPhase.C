// SPDX-License-Identifier: GPL-3.0-or-later
// A continuum of material points in the place of grains: making it and moving it.

#include "materialPointsPhase.H"

#include "addToRunTimeSelectionTable.H"
#include "grainSnapshot.H"
#include "keywords.H"
#include "periodicity.H"

namespace Foam
{
    defineTypeName(materialPointsPhase);
    addToRunTimeSelectionTable(granularPhase, materialPointsPhase, dictionary);
}


Foam::pointGrid Foam::materialPointsPhase::gridOf
(
    const fvMesh& mesh,
    const dictionary& dict
)
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
                "cellSize", "pointsPerCell", "transfer", "averaging",
                "courant", "timeStep", "walls", "outflow", "contact",
                "bodies"
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
    restarted_(false),
    timeStep_(0),
    nLeft_(0)
{
    Info<< "Grains: material points" << endl;

    addWalls();
    openSides();

    const fileName state(stateOnDisk());
    restarted_ = state.size();
    method_.addBodies(dict_, !restarted_);
    setWallFriction();
    readSettling();

    for (const word& body : method_.bodies())
    {
        const dictionary& of = dict_.subDict("bodies").subDict(body);
        const scalar own = of.get<scalar>("density");
        const scalar solid = of.getOrDefault<scalar>("solidDensity", own);

        if (solid < own)
        {
            FatalIOErrorInFunction(of)
                << "solidDensity is " << solid << " kg/m3, less than density,"
                << " which is " << own << " with the pores." << nl
                << "    Give that of the solid alone, as 2650 for sand."
                << exit(FatalIOError);
        }
        solidDensity_.append(solid);
    }

    // Dry, a grainDiameter is of the law alone, and bodies may differ in it
    if (dict.lookupOrDefault<word>("fluid", "volumeOfFluid") != "none")
    {
        setCoarseGraining(dict.found("coarseGraining"));
    }

    timeStep_ = readTimeStep();

    if (restarted_)
    {
        readState(state);
    }
    refresh();

    Info<< "    " << nTotal() << " points in cells of " << method_.grid().h()
        << " m, step " << timeStep_ << " s, exchange every "
        << stepsPerExchange << " steps = " << exchangeInterval() << " s" << nl
        << endl;
}


void Foam::materialPointsPhase::setCoarseGraining(const bool given)
{
    const label perCell = dict_.getOrDefault<label>("pointsPerCell", 2);
    const scalar volume =
        method_.grid().cubeVolume(method_.grid().h()/perCell);
    scalar ratio = 0;

    forAll(method_.bodies(), i)
    {
        const dictionary& body =
            dict_.subDict("bodies").subDict(method_.bodies()[i]);
        if (!body.found("grainDiameter"))
        {
            continue;
        }

        const scalar grain = body.get<scalar>("grainDiameter");
        const scalar point =
            cbrt(6/M_PI*volume*body.get<scalar>("density")/solidDensity_[i]);

        if (!(grain > 0))
        {
            FatalIOErrorInFunction(body)
                << "grainDiameter is " << grain << " m; it must be above zero."
                << exit(FatalIOError);
        }
        if (ratio > 0 && mag(point/grain - ratio) > 1e-3*ratio)
        {
            FatalIOErrorInFunction(body)
                << "A point stands for grains of " << grain << " m, "
                << point/grain << " times as large as they are, and in another"
                << " body " << ratio << " times: all bodies have one ratio."
                << nl << "    Give each a grainDiameter of "
                << point/ratio << " m."
                << exit(FatalIOError);
        }
        if (given)
        {
            FatalIOErrorInFunction(body)
                << "coarseGraining follows from grainDiameter: "
                << point/grain << "." << nl
                << "    Remove coarseGraining, or grainDiameter."
                << exit(FatalIOError);
        }
        ratio = point/grain;
    }

    if (ratio > 0)
    {
        coarseGraining_ = ratio;
    }
}


Foam::scalar Foam::materialPointsPhase::readTimeStep() const
{
    // Two digits, so that times to write can be whole numbers of intervals
    const scalar stable = method_.restStep();
    const scalar unit = std::pow(10.0, std::floor(std::log10(stable)) - 1);
    const scalar step = dict_.getOrDefault<scalar>
    (
        "timeStep", unit*std::floor(stable/unit)
    );

    if (!(step > 0))
    {
        FatalIOErrorInFunction(dict_)
            << "timeStep is " << step << " s; it must be above zero."
            << exit(FatalIOError);
    }

    return step;
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


void Foam::materialPointsPhase::readSettling()
{
    for (const word& body : method_.bodies())
    {
        const dictionary settling
        (
            keywords::sub
            (
                dict_.subDict("bodies").subDict(body),
                "settling",
                {"time", "damping"}
            )
        );
        const scalar rate = settling.getOrDefault<scalar>("damping", 20);
        const scalar time = settling.getOrDefault<scalar>("time", 0);

        if (!(rate > 0 && time >= 0))
        {
            FatalIOErrorInFunction(settling)
                << "settling of " << body << " has damping " << rate
                << " 1/s and time " << time << " s; damping must be above zero"
                << " and time not below." << exit(FatalIOError);
        }

        const label i = settledAt_.size();
        settledAt_.append(time);
        settles_.append(mesh_.time().value() < time*(1 - 1e-9));
        method_.setDamping(i, settles_[i] ? rate : 0);
    }
}


void Foam::materialPointsPhase::endSettling()
{
    forAll(settledAt_, body)
    {
        if
        (
            settles_[body]
         && mesh_.time().value() >= settledAt_[body]*(1 - 1e-9)
        )
        {
            settles_[body] = false;
            method_.setDamping(body, 0);
            method_.forgetStrain(body);
        }
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
        method_.step(dt);
        remaining -= dt;
    }
}


void Foam::materialPointsPhase::end()
{
    endSettling();
    refresh();
}


void Foam::materialPointsPhase::advance()
{
    begin();
    move(exchangeInterval());
    end();
}


void Foam::materialPointsPhase::refresh()
{
    const pointSet& p = method_.points();

    halfCurl_.setSize(p.size());
    solidRadius_.setSize(p.size());
    meanForce_.setSize(p.size());
    noTorque_.setSize(p.size(), Zero);

    forAll(p.x, i)
    {
        const tensor& L = p.gradient[i];
        halfCurl_[i] = 0.5*vector
        (
            L.zy() - L.yz(), L.xz() - L.zx(), L.yx() - L.xy()
        );
        solidRadius_[i] = cbrt
        (
            0.75/M_PI*p.mass[i]/solidDensity_[p.body[i]]
        );
        meanForce_[i] = p.mass[i]/exchangeInterval()*(p.U[i] - p.before[i]);
    }

    position_.shallowCopy(p.x);
    velocity_.shallowCopy(p.U);
    angularVelocity_.shallowCopy(halfCurl_);
    radius_.shallowCopy(solidRadius_);
    mass_.shallowCopy(p.mass);
    id_.shallowCopy(p.id);
    totalForce_.shallowCopy(meanForce_);
    fluidForce_.shallowCopy(p.force);
    fluidTorque_.shallowCopy(noTorque_);

    nLeft_ = returnReduce(method_.nLeft(), sumOp<label>());
}


Foam::dictionary Foam::materialPointsPhase::activePhysics() const
{
    dictionary result(granularPhase::activePhysics());

    for (const char* key : {"cellSize", "pointsPerCell", "courant", "averaging"})
    {
        if (dict_.found(key))
        {
            result.add(*dict_.findEntry(key, keyType::LITERAL));
        }
    }
    result.add("transfer", keywords::sub(dict_, "transfer"));
    result.add("walls", keywords::sub(dict_, "walls"));
    result.add("contact", keywords::sub(dict_, "contact"));
    result.add("bodies", keywords::sub(dict_, "bodies"));

    return result;
}


Foam::autoPtr<Foam::grainSnapshot> Foam::materialPointsPhase::snapshot() const
{
    auto result = autoPtr<grainSnapshot>::New(size());
    grainSnapshot& grains = *result;
    const pointSet& p = method_.points();

    grains.id = p.id;
    grains.position = p.x;
    grains.U = p.U;
    grains.omega = halfCurl_;
    grains.mass = p.mass;
    grains.force = p.force;

    forAll(p.x, i)
    {
        grains.type[i] = p.body[i] + 1;
        grains.d[i] = 2*solidRadius_[i];
        grains.contactForce[i] = meanForce_[i] - p.force[i] - p.mass[i]*g_;
        grains.stressMoment[i] = p.volume[i]*p.stress[i];
    }

    const wordList& walls = method_.walls().names();
    forAll(walls, wall)
    {
        grains.wallForce.insert
        (
            walls[wall],
            vectorField(method_.wallImpulse(wall)/exchangeInterval())
        );
    }

    return result;
}
