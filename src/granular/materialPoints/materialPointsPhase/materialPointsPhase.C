// SPDX-License-Identifier: GPL-3.0-or-later
// A continuum of material points in the place of grains: making it and moving it.

#include "materialPointsPhase.H"

#include "addToRunTimeSelectionTable.H"
#include "foamCompatibility.H"
#include "grainSnapshot.H"
#include "keywords.H"
#include "periodicity.H"
#include "unitConversion.H"
#include "wallPolyPatch.H"

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
    const label stepsPerExchange
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
                "courant", "timeStep", "walls", "outflow", "bodies"
            }
        )
    ),
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


bool Foam::materialPointsPhase::isWall(const polyPatch& patch) const
{
    return isA<wallPolyPatch>(patch) && patches_.match(patch.name());
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


Foam::List<Foam::pointField> Foam::materialPointsPhase::faces
(
    const polyPatch& patch
)
{
    List<List<pointField>> ofRanks(Pstream::nProcs());
    List<pointField>& mine = ofRanks[Pstream::myProcNo()];
    mine.setSize(patch.size());

    forAll(patch, i)
    {
        mine[i] = patch[i].points(patch.points());
    }
    Pstream::gatherList(ofRanks);
    compatibility::broadcast(ofRanks);

    DynamicList<pointField> result;
    for (const List<pointField>& some : ofRanks)
    {
        result.append(some);
    }
    return List<pointField>(std::move(result));
}


void Foam::materialPointsPhase::addWalls()
{
    const dictionary walls(keywords::sub(dict_, "walls"));
    const dictionary frictions(keywords::sub(walls, "frictions"));
    const scalar friction = walls.getOrDefault<scalar>("friction", 0);
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    keywords::checkPatterns(frictions, patches.names());

    // Those behind are cuts between ranks, other ones on each
    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];

        if (isWall(patch))
        {
            const label wall = method_.walls().add
            (
                patch.name(),
                frictions.getOrDefault<scalar>(patch.name(), friction)
            );

            for (const pointField& face : faces(patch))
            {
                method_.walls().addFace(wall, face);
            }
        }
    }

    method_.walls().findNodes();
}


bool Foam::materialPointsPhase::liesIn
(
    const boundBox& bounds,
    const label side
) const
{
    const boundBox& box = mesh_.bounds();
    const direction d = side/2;
    const scalar at = (side % 2 ? box.max() : box.min())[d];
    const scalar little = 1e-6*box.mag();

    return
        mag(bounds.min()[d] - at) < little
     && mag(bounds.max()[d] - at) < little;
}


void Foam::materialPointsPhase::checkAllOpen
(
    const label side,
    const word& opened,
    const wordRes& outflow
) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];
        bool shares = false;

        for (const face& f : patch)
        {
            shares =
                shares || liesIn(boundBox(patch.points(), f, false), side);
        }

        if (!outflow.match(patch.name()) && returnReduce(shares, orOp<bool>()))
        {
            FatalIOErrorInFunction(dict_)
                << "Patch " << opened << " of outflow is not the whole side of"
                << " the mesh's box: faces of " << patch.name() << " are in it,"
                << " too, and points would leave there as well." << nl
                << "    Name both in outflow, or shape the mesh so that "
                << opened << " is alone in its side." << exit(FatalIOError);
        }
    }
}


void Foam::materialPointsPhase::openSides()
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const wordRes outflow
    (
        keywords::patterns(dict_, "outflow", patches.names())
    );

    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];
        if (!outflow.match(patch.name()))
        {
            continue;
        }

        const boundBox bounds(patch.localPoints(), true);
        bool found = false;

        for (label side = 0; side < 6; ++side)
        {
            if (liesIn(bounds, side))
            {
                checkAllOpen(side, patch.name(), outflow);
                method_.open(side);
                found = true;
            }
        }

        if (!found)
        {
            FatalIOErrorInFunction(dict_)
                << "Patch " << patch.name() << " of outflow is in no side of the"
                << " mesh's box " << mesh_.bounds() << nl
                << "    Points leave where they cross such a side: end the mesh"
                << " there." << exit(FatalIOError);
        }
    }
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


void Foam::materialPointsPhase::advance()
{
    method_.points().before = method_.points().U;
    method_.walls().resetImpulse();

    scalar remaining = exchangeInterval();
    while (remaining > 1e-9*timeStep_)
    {
        // Equal steps, and no short one at the end
        const scalar dt =
            remaining/std::ceil(remaining/method_.stableStep()*(1 - 1e-9));
        method_.step(dt);
        remaining -= dt;
    }

    refresh();
}


void Foam::materialPointsPhase::refresh()
{
    const pointSet& p = method_.points();

    angularVelocity_.setSize(p.size());
    radius_.setSize(p.size());
    totalForce_.setSize(p.size());
    noTorque_.setSize(p.size(), Zero);

    forAll(p.x, i)
    {
        const tensor& L = p.gradient[i];
        angularVelocity_[i] = 0.5*vector
        (
            L.zy() - L.yz(), L.xz() - L.zx(), L.yx() - L.xy()
        );
        radius_[i] = cbrt
        (
            0.75/M_PI*p.mass[i]/solidDensity_[p.body[i]]
        );
        totalForce_[i] = p.mass[i]/exchangeInterval()*(p.U[i] - p.before[i]);
    }

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
    grains.omega = angularVelocity_;
    grains.mass = p.mass;
    grains.force = p.force;

    forAll(p.x, i)
    {
        grains.type[i] = p.body[i] + 1;
        grains.d[i] = 2*radius_[i];
        grains.contactForce[i] = totalForce_[i] - p.force[i] - p.mass[i]*g_;
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
