// SPDX-License-Identifier: GPL-3.0-or-later
// One snapshot of the grains for all function objects of a time.

#include "snapshotCache.H"

#include "Time.H"
#include "grainBodies.H"

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
    images_(mesh),
    clumps_(false)
{}


const Foam::grainSnapshot& Foam::snapshotCache::present()
{
    const Time& now = mesh_.time();

    // The index alone does not distinguish times of postProcess from the start
    if (!grains_ || timeIndex_ != now.timeIndex() || time_ != now.value())
    {
        grains_ = grainSnapshot::New(mesh_);
        bodies_.clear();
        clumps_ = grains_->hasClumps();
        timeIndex_ = now.timeIndex();
        time_ = now.value();
    }

    return *grains_;
}


const Foam::grainSnapshot& Foam::snapshotCache::presentBodies()
{
    const grainSnapshot& all = present();

    if (clumps_ && !bodies_)
    {
        bodies_ = grainBodies(all, images_);
    }

    return clumps_ ? *bodies_ : all;
}


Foam::snapshotCache& Foam::snapshotCache::of(const fvMesh& mesh)
{
    auto* cache = mesh.getObjectPtr<snapshotCache>(typeName);

    if (!cache)
    {
        cache = new snapshotCache(mesh);
        cache->store();
    }

    return *cache;
}
