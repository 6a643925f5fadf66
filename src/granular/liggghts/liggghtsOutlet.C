// SPDX-License-Identifier: GPL-3.0-or-later
// Grains computed by LIGGGHTS: which may leave the mesh, which came and which did.

#include "liggghtsOutlet.H"

#include "Time.H"
#include "clumpRemoval.H"

#include <liggghts/domain.h>
#include <liggghts/fix.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/update.h>

Foam::liggghtsOutlet::liggghtsOutlet
(
    const granularPhase& grains,
    const fvMesh& mesh,
    const liggghtsInstance& liggghts,
    const wordRes& outflow
)
:
    grains_(grains),
    mesh_(mesh),
    liggghts_(liggghts),
    openings_(openings(outflow)),
    images_(mesh),
    removal_(nullptr),
    nGrains_(0),
    nInserted_(0),
    nEntered_(0),
    nLeft_(0),
    warnedOfVanished_(false)
{}


Foam::List<Foam::liggghtsOutlet::opening> Foam::liggghtsOutlet::openings
(
    const wordRes& outflow
) const
{
    DynamicList<opening> result;

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();

    // Those behind are cuts between ranks, other ones on each
    for (label i = 0; i < patches.nNonProcessor(); ++i)
    {
        const polyPatch& patch = patches[i];

        if (outflow.match(patch.name()))
        {
            const vectorField areas(patch.faceAreas());
            const vectorField centres(patch.faceCentres());
            const scalar area = gSum(mag(areas));

            if (area > 0)
            {
                const vector outwards(gSum(areas));

                if (mag(outwards) < 0.99*area)
                {
                    FatalErrorInFunction
                        << "Patch " << patch.name() << " of LIGGGHTS/outflow"
                        << " is not flat, or has several sides: grains leave"
                        << " across one plane." << nl
                        << "    Give each side a patch of its own."
                        << exit(FatalError);
                }

                result.append
                (
                    opening
                    {
                        gSum(mag(areas)*centres)/area,
                        outwards/mag(outwards),
                        boundBox(patch.localPoints(), true)
                    }
                );
            }
        }
    }

    return List<opening>(std::move(result));
}


Foam::List<LAMMPS_NS::Fix*> Foam::liggghtsOutlet::insertions() const
{
    const LAMMPS_NS::Modify& modify = *liggghts_->modify;
    DynamicList<LAMMPS_NS::Fix*> result;

    for (label i = 0; i < modify.nfix; ++i)
    {
        if (string(modify.fix[i]->style).substr(0, 7) == "insert/")
        {
            result.append(modify.fix[i]);
        }
    }

    return List<LAMMPS_NS::Fix*>(std::move(result));
}


Foam::label Foam::liggghtsOutlet::nInserted() const
{
    scalar n = 0;

    for (LAMMPS_NS::Fix* fix : insertions())
    {
        n += fix->compute_vector(0);
    }

    return label(n + 0.5);
}


bool Foam::liggghtsOutlet::mayLeave(const point& p, const vector& U) const
{
    for (const opening& way : openings_)
    {
        const scalar beyond = (p - way.centre) & way.outwards;
        const scalar speed = U & way.outwards;

        if (beyond <= 0)
        {
            continue;
        }

        // One that is out for longer was checked when it left
        if (beyond > 2*grains_.exchangeInterval()*mag(speed))
        {
            return true;
        }

        // Where its centre crossed the plane of the patch; its path bends a little
        boundBox bounds(way.bounds);
        bounds.inflate(1e-6);
        bounds.min() -= vector::uniform(beyond);
        bounds.max() += vector::uniform(beyond);

        if (bounds.contains(images_.wrap(p - beyond/speed*U)))
        {
            return true;
        }
    }

    return false;
}


bool Foam::liggghtsOutlet::cameToSide
(
    const point& from,
    const vector& velocity,
    point& leavesAt
) const
{
    // Through which side of LIGGGHTS's box it went, within twice the interval
    // since forces may have changed its velocity
    const LAMMPS_NS::Domain& domain = *liggghts_->domain;
    scalar soonest = 2*grains_.exchangeInterval();
    bool out = false;

    for (direction k = 0; k < 3; ++k)
    {
        if (domain.periodicity[k])
        {
            continue;
        }

        // LIGGGHTS takes out what is beyond a side when it makes new lists of
        // neighbours: until then it may fall back
        if (from[k] > domain.boxhi[k] || from[k] < domain.boxlo[k])
        {
            leavesAt = from;
            return true;
        }
        if (velocity[k] == 0)
        {
            continue;
        }

        const scalar side =
            velocity[k] > 0 ? domain.boxhi[k] : domain.boxlo[k];
        const scalar after = max((side - from[k])/velocity[k], scalar(0));

        if (after < soonest)
        {
            out = true;
            soonest = after;
            leavesAt = from + after*velocity;
            leavesAt[k] = side + sign(velocity[k])*1e-6*mesh_.bounds().mag();
        }
    }

    return out || wasTurnedOut(from, velocity, leavesAt);
}


bool Foam::liggghtsOutlet::wasTurnedOut
(
    const point& from,
    const vector& velocity,
    point& leavesAt
) const
{
    const scalar reach = 2*grains_.exchangeInterval()*mag(velocity);

    for (const opening& way : openings_)
    {
        const scalar distance = (way.centre - from) & way.outwards;
        boundBox bounds(way.bounds);
        bounds.inflate(1e-6);

        if (distance < reach && bounds.contains(from + distance*way.outwards))
        {
            leavesAt =
                from + (distance + 1e-6*mesh_.bounds().mag())*way.outwards;
            return true;
        }
    }

    return false;
}


void Foam::liggghtsOutlet::begin()
{
    removal_ = clumpRemoval::of(liggghts_);
    if (removal_ && removal_->departed().size())
    {
        FatalErrorInFunction
            << removal_->departed().size() << " clumps reach out of the grains' box at the"
            << " start, the first near " << (*removal_->departed().cbegin()).first()
            << " m." << nl << "    Make the region of create_box (domain of packingDict)"
            << " larger, or place them inside." << exit(FatalError);
    }
    nGrains_ = grains_.nBodies();
    nInserted_ = nInserted();
}


void Foam::liggghtsOutlet::note()
{
    before_.note(grains_.id(), grains_.position(), grains_.velocity());

    if (removal_)
    {
        removal_->forget();
    }
    clumpBefore_.clear();
    forAll(grains_.clump(), i)
    {
        clumpBefore_.insert(grains_.id()[i], grains_.clump()[i]);
    }
}


void Foam::liggghtsOutlet::count()
{
    const label inserted = nInserted();
    const label now = grains_.nBodies();
    const label gone = nGrains_ + inserted - nInserted_ - now;

    if (gone > 0)
    {
        nLeft_ += gone - nVanished(gone);
    }

    nEntered_ += inserted - nInserted_;
    nInserted_ = inserted;
    nGrains_ = now;
}


void Foam::liggghtsOutlet::endInsertions() const
{
    // One that had brought all its grains before a restart stays due at the first
    // step, and LIGGGHTS refuses whatever it initialises after that
    for (LAMMPS_NS::Fix* fix : insertions())
    {
        const bool isPast = fix->next_reneighbor < liggghts_->update->ntimestep;

        if (fix->next_reneighbor > 0 && isPast)
        {
            fix->next_reneighbor = 0;
        }
    }
}


Foam::label Foam::liggghtsOutlet::nStepsToInsertion() const
{
    label steps = labelMax;

    for (const LAMMPS_NS::Fix* fix : insertions())
    {
        if (fix->next_reneighbor > liggghts_->update->ntimestep)
        {
            steps = min
            (
                steps,
                label(fix->next_reneighbor - liggghts_->update->ntimestep)
            );
        }
    }

    return steps;
}
