// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method: limits of the step, and its order.

#include "materialPointMethod.H"

#include "PstreamReduceOps.H"
#include "Switch.H"
#include "keywords.H"

namespace
{
    using namespace Foam;

    //- Steps between two sortings: few points leave their cell in that time
    constexpr label sortInterval = 50;

    //- Share of the change of velocity, 0 where it is APIC
    scalar flipShare(const dictionary& dict)
    {
        const dictionary transfer
        (
            keywords::sub(dict, "transfer", {"model", "share"})
        );
        const word model
        (
            keywords::choice
            (
                transfer, "model", "transfer", {"APIC", "FLIP"}, "APIC"
            )
        );
        const scalar share = transfer.getOrDefault<scalar>("share", 0.98);

        if (!(share > 0 && share <= 1))
        {
            FatalIOErrorInFunction(dict)
                << "transfer/share is " << share << "; it must lie above 0 and"
                << " up to 1 (pure FLIP)." << exit(FatalIOError);
        }

        return model == "APIC" ? 0 : share;
    }
}


Foam::materialPointMethod::materialPointMethod
(
    const pointGrid& grid,
    const vector& g,
    const dictionary& dict
)
:
    grid_(grid),
    walls_(grid_),
    outlets_(grid_),
    gateSide_(0),
    g_(g),
    flipShare_(flipShare(dict)),
    averaging_(dict.getOrDefault<Switch>("averaging", true)),
    densityAveraging_(dict.getOrDefault<Switch>("densityAveraging", false)),
    shifting_(dict.getOrDefault<Switch>("shifting", false)),
    courant_(dict.getOrDefault<scalar>("courant", 0.4)),
    sideWalls_(dict, grid_),
    nLeft_(0),
    sinceSorted_(sortInterval),
    nodes_(1)
{
    if (!(courant_ > 0 && courant_ <= 1))
    {
        FatalIOErrorInFunction(dict)
            << "courant is " << courant_ << "; it must lie above 0 and up to 1"
            << " (0.3 to 0.5 is usual)." << exit(FatalIOError);
    }
}


Foam::scalar Foam::materialPointMethod::waveSpeed() const
{
    scalar c = 0;
    for (const constitutiveLaw& law : laws_)
    {
        c = max(c, law.waveSpeed());
    }
    return c;
}


Foam::scalar Foam::materialPointMethod::stableStep() const
{
    scalar fastest = 0;
    for (const vector& U : points_.U)
    {
        fastest = max(fastest, magSqr(U));
    }
    reduce(fastest, maxOp<scalar>());

    return courant_*grid_.h()/(waveSpeed() + sqrt(fastest));
}


Foam::scalar Foam::materialPointMethod::restStep() const
{
    return courant_*grid_.h()/waveSpeed();
}


void Foam::materialPointMethod::step(const scalar dt, const scalar damping)
{
    if (sinceSorted_++ >= sortInterval)
    {
        sortPoints();
        sinceSorted_ = 1;
    }

    if (damping > 0 || max(damping_) > 0)
    {
        damp(dt, damping);
    }

    if (gate_)
    {
        from_ = points_.x;
    }
    cell_.setSize(points_.size());
    dilation_.setSize(points_.size());

    if (grid_.nDims() == 2)
    {
        transfer<2>(dt);
    }
    else
    {
        transfer<3>(dt);
    }

    findDilation(dt);
    if (densityAveraging_)
    {
        averageDensity();
    }

    forAll(laws_, body)
    {
        laws_[body].update(points_, body, dilation_, dt);
    }

    forAll(points_.x, i)
    {
        walls_.putBack(points_.x[i], cell_[i]);
        if (gate_)
        {
            gate_->putBack(points_.x[i], from_[i]);
        }
    }

    travel();
}


void Foam::materialPointMethod::damp(const scalar dt, const scalar damping)
{
    scalarField kept(damping_.size());
    forAll(kept, body)
    {
        kept[body] = max(1 - (damping + damping_[body])*dt, scalar(0));
    }

    forAll(points_.x, i)
    {
        points_.U[i] *= kept[points_.body[i]];
        points_.gradient[i] *= kept[points_.body[i]];
    }
}


void Foam::materialPointMethod::beginSettling(const label body, const scalar rate)
{
    damping_[body] = rate;
    laws_[body].setSettling(true);
}


void Foam::materialPointMethod::endSettling(const label body)
{
    damping_[body] = 0;
    laws_[body].setSettling(false);

    forAll(points_.x, i)
    {
        if (points_.body[i] == body)
        {
            points_.strain[i] = 0;
            points_.netStrain[i] = Zero;
        }
    }
}


void Foam::materialPointMethod::findDilation(const scalar dt)
{
    pointSet& p = points_;

    forAll(p.x, i)
    {
        dilation_[i] = tr(p.gradient[i]);
    }

    if (averaging_)
    {
        cellVolume_ = Zero;
        cellDilation_ = Zero;

        const label n = grid_.nNodes();
        forAll(p.x, i)
        {
            const label cell = cell_[i] + n*fieldOf(i);
            cellVolume_[cell] += p.volume[i];
            cellDilation_[cell] += p.volume[i]*dilation_[i];
        }
        forAll(p.x, i)
        {
            const label cell = cell_[i] + n*fieldOf(i);
            dilation_[i] = cellDilation_[cell]/cellVolume_[cell];
        }
    }

    forAll(p.x, i)
    {
        p.volume[i] *= 1 + dt*dilation_[i];
    }
}


void Foam::materialPointMethod::averageDensity()
{
    pointSet& p = points_;
    const label n = grid_.nNodes();
    bodyVolume_.setSize(n*laws_.size());
    bodyMass_.setSize(n*laws_.size());
    bodyVolume_ = Zero;
    bodyMass_ = Zero;

    forAll(p.x, i)
    {
        const label cell = cell_[i] + n*p.body[i];
        bodyVolume_[cell] += p.volume[i];
        bodyMass_[cell] += p.mass[i];
    }
    forAll(p.x, i)
    {
        const label cell = cell_[i] + n*p.body[i];
        p.volume[i] = p.mass[i]*bodyVolume_[cell]/bodyMass_[cell];
    }
}


void Foam::materialPointMethod::sortPoints()
{
    // Counting sort by cells, which keeps the order within one
    const label n = points_.size();
    labelList begin(grid_.nNodes() + 1, 0);
    labelList cells(n);

    forAll(cells, i)
    {
        FixedList<label, 3> at(0);
        for (label k = 0; k < grid_.nDims(); ++k)
        {
            at[k] = pointGrid::cell(grid_.coordinate(points_.x[i], k));
        }
        cells[i] = grid_.node(at);
        ++begin[cells[i] + 1];
    }
    for (label c = 0; c < grid_.nNodes(); ++c)
    {
        begin[c + 1] += begin[c];
    }

    labelList order(n);
    forAll(cells, i)
    {
        order[begin[cells[i]]++] = i;
    }

    points_.take(order);
}
