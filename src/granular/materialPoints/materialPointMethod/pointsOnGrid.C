// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method: from points to nodes and back.

#include "materialPointMethod.H"
#include "sharedNodes.H"

namespace
{
    //- The lane that a plane leaves free: what side walls would take of the momentum of
    //  a node, were it to slide [N s]
    constexpr int sideLane = 3;
}


Foam::lanes Foam::materialPointMethod::toLanes
(
    const scalar first,
    const vector& v
) const
{
    const FixedList<direction, 3>& a = grid_.axes();

    return lanes
    (
        first, v[a[0]], v[a[1]], grid_.nDims() == 3 ? v[a[2]] : 0
    );
}


Foam::vector Foam::materialPointMethod::toVector(const lanes& l) const
{
    vector result(Zero);
    for (label k = 0; k < grid_.nDims(); ++k)
    {
        result[grid_.axes()[k]] = l[k + 1];
    }
    return result;
}


template<int D>
void Foam::materialPointMethod::momentumToNodes(const scalar dt)
{
    const bool APIC = flipShare_ == 0;
    const scalar h = grid_.h();
    const pointSet& p = points_;

    setZero(nodes_);

    forAll(p.x, i)
    {
        lanes slope[D];

        for (int k = 0; k < D; ++k)
        {
            const direction d = grid_.axes()[k];
            slope[k] = lanes::Zero();

            if (APIC)
            {
                const tensor A
                (
                    (h*p.mass[i])*p.gradient[i]
                  - (4*dt/h*p.volume[i])*tensor(p.stress[i])
                );
                slope[k] = toLanes(0, vector(A[d], A[3 + d], A[6 + d]));
            }
        }

        vector momentum(p.mass[i]*p.U[i]);
        if (APIC)
        {
            momentum += dt*p.force[i];
        }

        lanes value(toLanes(p.mass[i], momentum));
        if (APIC && sideWalls_.brake())
        {
            value[sideLane] = sideWalls_.impulse(p.stress[i], p.volume[i], dt);
        }
        splineStencil<D>(grid_, p.x[i]).add(nodes_[fieldOf(i)], value, slope);
    }

    sumShared(grid_, nodes_);
}


template<int D>
void Foam::materialPointMethod::forceToNodes(const scalar dt)
{
    const scalar h = grid_.h();
    const pointSet& p = points_;

    setZero(change_);

    forAll(p.x, i)
    {
        lanes slope[D];
        const tensor A((-4*dt/h*p.volume[i])*tensor(p.stress[i]));

        for (int k = 0; k < D; ++k)
        {
            const direction d = grid_.axes()[k];
            slope[k] = toLanes(0, vector(A[d], A[3 + d], A[6 + d]));
        }

        lanes value(toLanes(0, dt*p.force[i]));
        if (sideWalls_.brake())
        {
            value[sideLane] = sideWalls_.impulse(p.stress[i], p.volume[i], dt);
        }
        splineStencil<D>(grid_, p.x[i]).add(change_[fieldOf(i)], value, slope);
    }

    sumShared(grid_, change_);
}


void Foam::materialPointMethod::moveNodes(const scalar dt)
{
    const lanes fall(toLanes(0, dt*g_));
    const bool FLIP = flipShare_ > 0;

    for (label field = 0; field < nFields(); ++field)
    {
        nodeLanes& nodes = nodes_[field];

        for (std::size_t i = 0; i < nodes.size(); ++i)
        {
            lanes& node = nodes[i];
            const scalar m = node[0];

            if (m <= 0)
            {
                continue;
            }

            node /= m;
            if (FLIP)
            {
                lanes& change = change_[field][i];
                const lanes before(node);
                node += change/m;
                change = before;
            }
            node += fall;
            node[0] = m;
            if (sideWalls_.brake())
            {
                sideWalls_.braking(field, i) = node[sideLane];
                node[sideLane] = 0;
            }
        }
    }
}


void Foam::materialPointMethod::applyWalls(const bool counts)
{
    for (label field = 0; field < nFields(); ++field)
    {
        walls_.apply(nodes_[field], field, counts);
        if (gate_)
        {
            gate_->apply(nodes_[field]);
        }
    }
}


void Foam::materialPointMethod::findChange()
{
    for (label field = 0; field < nFields(); ++field)
    {
        nodeLanes& change = change_[field];

        for (std::size_t i = 0; i < change.size(); ++i)
        {
            change[i] = nodes_[field][i] - change[i];
        }
    }
}


void Foam::materialPointMethod::divideByMass()
{
    for (nodeLanes& nodes : nodes_)
    {
        for (lanes& node : nodes)
        {
            const scalar m = node[0];
            node = m > 0 ? lanes(node/m) : lanes(lanes::Zero());
            node[0] = m;
        }
    }
}


template<int D>
void Foam::materialPointMethod::setGradient
(
    const label i,
    const lanes* moment
)
{
    const scalar factor = 4/grid_.h();
    tensor& L = points_.gradient[i];
    L = Zero;

    for (int c = 0; c < D; ++c)
    {
        for (int r = 0; r < D; ++r)
        {
            L[3*grid_.axes()[r] + grid_.axes()[c]] = factor*moment[c][r + 1];
        }
    }
}


template<int D>
void Foam::materialPointMethod::velocityToPoints(const scalar dt)
{
    pointSet& p = points_;

    forAll(p.x, i)
    {
        const splineStencil<D> stencil(grid_, p.x[i]);
        lanes moment[D];
        p.U[i] = toVector(stencil.mean(nodes_[fieldOf(i)], moment));
        setGradient<D>(i, moment);

        cell_[i] = stencil.cell();
        p.x[i] += dt*p.U[i];
        if (crowded_)
        {
            p.x[i] += shift(stencil, fieldOf(i));
        }
    }
}


template<int D>
void Foam::materialPointMethod::changeToPoints(const scalar dt)
{
    pointSet& p = points_;
    goesTo_.setSize(p.size());

    forAll(p.x, i)
    {
        const splineStencil<D> stencil(grid_, p.x[i]);
        const vector U(toVector(stencil.mean(nodes_[fieldOf(i)])));
        const vector change(toVector(stencil.mean(change_[fieldOf(i)])));

        p.U[i] = flipShare_*(p.U[i] + change) + (1 - flipShare_)*U;
        goesTo_[i] = p.x[i] + dt*U;
        if (crowded_)
        {
            goesTo_[i] += shift(stencil, fieldOf(i));
        }
    }
}


template<int D>
void Foam::materialPointMethod::gradientToPoints()
{
    pointSet& p = points_;

    forAll(p.x, i)
    {
        const splineStencil<D> stencil(grid_, p.x[i]);
        lanes moment[D];
        stencil.mean(nodes_[fieldOf(i)], moment);
        setGradient<D>(i, moment);

        cell_[i] = stencil.cell();
        p.x[i] = goesTo_[i];
    }
}


template<int D>
void Foam::materialPointMethod::transfer(const scalar dt)
{
    findCrowding<D>();
    momentumToNodes<D>(dt);

    if (flipShare_ == 0)
    {
        moveNodes(dt);
        touch<D>();
        applyWalls(true);
        sideWalls_.apply(nodes_);
        velocityToPoints<D>(dt);
        return;
    }

    forceToNodes<D>(dt);
    moveNodes(dt);
    touch<D>();
    applyWalls(true);
    sideWalls_.apply(nodes_);
    findChange();
    changeToPoints<D>(dt);

    // Second mapping: the gradient is that of what the points now carry
    momentumToNodes<D>(dt);
    divideByMass();
    touch<D>();
    applyWalls(false);
    gradientToPoints<D>();
}


template void Foam::materialPointMethod::transfer<2>(const scalar);
template void Foam::materialPointMethod::transfer<3>(const scalar);
