// SPDX-License-Identifier: GPL-3.0-or-later
// One snapshot of the grains for all function objects of a time.

#include "snapshotCache.H"

#include "Time.H"

namespace Foam
{
    defineTypeNameAndDebug(snapshotCache, 0);
}


Foam::snapshotCache::snapshotCache(const fvMesh& mesh)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            mesh.time().constant(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    mesh_(mesh),
    time_(0),
    timeIndex_(-1),
    clumps_(false)
{}


const Foam::grainSnapshot& Foam::snapshotCache::present()
{
    const Time& now = mesh_.time();

    // The index alone does not distinguish times of postProcess from the start
    if (!grains_ || timeIndex_ != now.timeIndex() || time_ != now.value())
    {
        grains_ = grainSnapshot::New(mesh_);
        clumps_ = grains_->hasClumps();
        timeIndex_ = now.timeIndex();
        time_ = now.value();
    }

    return *grains_;
}


void Foam::snapshotCache::checkNoClumps(const functionObject& asks) const
{
    if (clumps_)
    {
        FatalErrorInFunction
            << "Function object " << asks.name() << " of type " << asks.type()
            << " takes each grain for a sphere, but there are clumps of spheres"
            << " that overlap." << nl
            << "    Take it out of system/controlDict. collisionLoad, displacedGrains and"
            << " grainStress do not know clumps."
            << exit(FatalError);
    }
}


const Foam::grainSnapshot& Foam::snapshotCache::get
(
    const fvMesh& mesh,
    const functionObject* takesNoClumps
)
{
    auto* cache = mesh.getObjectPtr<snapshotCache>(typeName);

    if (!cache)
    {
        cache = new snapshotCache(mesh);
        cache->store();
    }

    const grainSnapshot& all = cache->present();
    if (takesNoClumps)
    {
        cache->checkNoClumps(*takesNoClumps);
    }

    return all;
}
