// SPDX-License-Identifier: GPL-3.0-or-later
// Grains of LIGGGHTS and a continuum of material points that touch.

#include "grainsOnPoints.H"

#include "addToRunTimeSelectionTable.H"
#include "grainSnapshot.H"
#include "hasFluid.H"
#include "keywords.H"
#include "periodicity.H"

#include <algorithm>

namespace Foam
{
    defineTypeName(grainsOnPoints);
    addToRunTimeSelectionTable(granularPhase, grainsOnPoints, dictionary);
}


namespace
{
    using namespace Foam;

    //- File of the points beside that of the grains
    const word stateOfPoints("points");

    //- What grains have, then what points have
    template<class ListType>
    void join
    (
        ListType& result,
        const UList<typename ListType::value_type>& grains,
        const UList<typename ListType::value_type>& points
    )
    {
        result.setSize(grains.size() + points.size());
        std::copy(grains.begin(), grains.end(), result.begin());
        std::copy(points.begin(), points.end(), result.begin() + grains.size());
    }
}


Foam::dictionary Foam::grainsOnPoints::settings
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    if (hasFluid(dict))
    {
        FatalIOErrorInFunction(dict)
            << "Grains on material points are computed without a fluid." << nl
            << "    Write: fluid none; in constant/granularProperties"
            << exit(FatalIOError);
    }

    const Vector<bool> repeats(periodicity(mesh).along());
    for (direction d = 0; d < 3; ++d)
    {
        if (repeats[d] && mesh.solutionD()[d] == 1)
        {
            FatalErrorInFunction
                << "The mesh repeats itself along " << "xyz"[d] << " (cyclic):"
                << " grains on material points need walls or open sides there."
                << nl << "    A slice that repeats itself sideways has patches of"
                << " type empty." << exit(FatalError);
        }
    }

    if (dict.found("coarseGraining"))
    {
        FatalIOErrorInFunction(dict)
            << "coarseGraining is that of grains in a fluid, and there is none"
            << " with " << typeName << "." << nl << "    Take it out."
            << exit(FatalIOError);
    }

    dictionary result
    (
        keywords::sub(dict, typeName, {"LIGGGHTS", "materialPoints", "contact"})
    );

    if (keywords::sub(result, "materialPoints").found("timeStep"))
    {
        FatalIOErrorInFunction(result)
            << "materialPoints/timeStep is not read here: intervals count the"
            << " DEM step of LIGGGHTS." << nl
            << "    Take it out." << exit(FatalIOError);
    }

    return result;
}


Foam::dictionary Foam::grainsOnPoints::withStep
(
    const dictionary& dict,
    const scalar step
)
{
    dictionary result(dict);
    dictionary points(keywords::sub(dict, "materialPoints"));
    // set() would round it to the digits that are written
    points.add("timeStep", step, true);
    result.set("materialPoints", points);

    // No fluid reaches these points: their diameters are of the law alone
    result.set("fluid", word("none"));
    return result;
}


Foam::grainsOnPoints::grainsOnPoints
(
    const fvMesh& mesh,
    const dictionary& dict,
    const vector& g,
    const label stepsPerExchange
)
:
    granularPhase(mesh, dict, stepsPerExchange),
    dict_(settings(mesh, dict)),
    grains_
    (
        mesh,
        dict_,
        g,
        stepsPerExchange,
        [this](const grainsInStep& grains) { coupleInDemStep(grains); }
    ),
    points_
    (
        mesh,
        withStep(dict_, grains_.timeStep()),
        g,
        stepsPerExchange,
        stateOfPoints
    ),
    contact_
    (
        keywords::sub(dict_, "contact"),
        pointDistance(),
        points_.method().grid().nDims()
    ),
    pointSteps_(readPointSteps()),
    done_(0),
    moved_(0)
{
    contact_.sort(points_.method().grid(), points_.method().points());
    refresh();

    Info<< "Grains on points: " << pointSteps_ << " steps of the points in "
        << stepsPerExchange << " DEM steps" << nl << endl;
}


Foam::scalar Foam::grainsOnPoints::pointDistance() const
{
    return
        points_.method().grid().h()
       /keywords::sub(dict_, "materialPoints")
            .getOrDefault<label>("pointsPerCell", 2);
}


Foam::label Foam::grainsOnPoints::readPointSteps() const
{
    // Of all that there were at the start, so that a restart has the same
    scalar lightest = GREAT;
    for (const constitutiveLaw& law : points_.method().laws())
    {
        lightest = min(lightest, law.density());
    }
    lightest *= points_.method().grid().cubeVolume(pointDistance());

    const scalar limit = contact_.largestStep(lightest);

    if (limit < timeStep())
    {
        FatalIOErrorInFunction(dict_)
            << "The contact of grains and points needs steps of at most "
            << limit << " s, and the DEM step is " << timeStep() << " s." << nl
            << "    Lower grainsOnPoints/contact/stiffness, or timestep in the"
            << " LIGGGHTS script." << exit(FatalIOError);
    }

    // Whole DEM steps, and no more of them than fit
    const scalar step = min(limit, points_.method().restStep());
    const label most = max
    (
        label(1),
        label(min(step/timeStep()*(1 + 1e-9), scalar(stepsPerExchange())))
    );
    return (stepsPerExchange() + most - 1)/most;
}


Foam::label Foam::grainsOnPoints::begins(const label k) const
{
    const int64_t n = stepsPerExchange();
    return label((k*n + pointSteps_ - 1)/pointSteps_);
}


void Foam::grainsOnPoints::coupleInDemStep(const grainsInStep& grains)
{
    const pointGrid& grid = points_.method().grid();
    const pointSet& points = points_.method().points();

    const label waiting = begins(moved_ + 1) - begins(moved_);

    contact_.act(grains, grid, points, points_.force(), waiting*timeStep());

    if (++done_ == begins(moved_ + 1))
    {
        for (vector& force : points_.force())
        {
            force /= waiting;
        }
        points_.move(waiting*timeStep());
        for (vector& force : points_.force())
        {
            force = Zero;
        }

        contact_.sort(grid, points);
        ++moved_;
    }
}


void Foam::grainsOnPoints::setFluidForce
(
    const UList<vector>&,
    const UList<vector>&
)
{
    FatalErrorInFunction
        << "Grains on material points take no force of a fluid."
        << exit(FatalError);
}


void Foam::grainsOnPoints::takeSteps(const entryHandler&)
{
    done_ = 0;
    moved_ = 0;
    points_.begin();
    grains_.advance();
    points_.end();
    refresh();
}


void Foam::grainsOnPoints::refresh()
{
    const auto show = [this](auto& view, auto& both, const auto list)
    {
        join(both, (grains_.*list)(), (points_.*list)());
        view.shallowCopy(both);
    };

    show(position_, positions_, &granularPhase::position);
    show(velocity_, velocities_, &granularPhase::velocity);
    show(angularVelocity_, angularVelocities_, &granularPhase::angularVelocity);
    show(radius_, radii_, &granularPhase::radius);
    show(mass_, masses_, &granularPhase::mass);
    show(id_, ids_, &granularPhase::id);
    show(totalForce_, totalForces_, &granularPhase::totalForce);
    show(fluidForce_, fluidForces_, &granularPhase::fluidForce);
    show(fluidTorque_, fluidTorques_, &granularPhase::fluidTorque);

    for (label i = grains_.size(); i < ids_.size(); ++i)
    {
        ids_[i] += firstPoint;
    }
}


Foam::dictionary Foam::grainsOnPoints::activePhysics() const
{
    dictionary result(granularPhase::activePhysics());
    result.add("LIGGGHTS", grains_.activePhysics());
    result.add("materialPoints", points_.activePhysics());
    result.add("contact", keywords::sub(dict_, "contact"));

    return result;
}


Foam::autoPtr<Foam::grainSnapshot> Foam::grainsOnPoints::snapshot() const
{
    const autoPtr<grainSnapshot> grains(grains_.snapshot());
    autoPtr<grainSnapshot> points(points_.snapshot());
    auto result = autoPtr<grainSnapshot>::New(size());
    grainSnapshot& all = *result;

    for (label& type : points->type)
    {
        type += grains_.nTypes();
    }

    join(all.position, grains->position, points->position);
    grainSnapshot::forEachField([&](const char*, const auto member)
    {
        join(all.*member, (*grains).*member, (*points).*member);
    });
    all.id = ids_;

    wordHashSet walls(grains->wallForce.toc());
    walls.insert(points->wallForce.toc());

    for (const word& wall : walls)
    {
        vectorField force;
        join
        (
            force,
            grains->wallForce.lookup
            (
                wall, vectorField(grains->size(), Zero)
            ),
            points->wallForce.lookup
            (
                wall, vectorField(points->size(), Zero)
            )
        );
        all.wallForce.insert(wall, force);
    }

    return result;
}


bool Foam::grainsOnPoints::writeState(const fileName& folder)
{
    const bool pointsComplete = points_.writeState(folder);
    const bool grainsComplete = grains_.writeState(folder);
    refresh();

    return pointsComplete && grainsComplete;
}
