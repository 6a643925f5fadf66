// SPDX-License-Identifier: GPL-3.0-or-later
// The material-point method: where bodies touch, and with which normal.

#include "materialPointMethod.H"
#include "sharedNodes.H"

template<int D>
void Foam::materialPointMethod::findTouching()
{
    touching_.clear();
    nearContact_ = false;

    for (label node = 0; node < grid_.nNodes(); ++node)
    {
        label reached = 0;
        for (const nodeLanes& nodes : nodes_)
        {
            reached += nodes[node][0] > 0;
        }
        if (reached < 2 || walls_.isHeld(node))
        {
            continue;
        }

        touching_.append(node);

        // The cells around it; a row too far at the rim does no harm
        for (label i = 0; i < (D == 3 ? 27 : 9); ++i)
        {
            label cell = node;
            for (label k = 0, rest = i; k < D; ++k, rest /= 3)
            {
                cell += (rest % 3 - 1)*grid_.stride(k);
            }
            if (cell >= 0 && cell < grid_.nNodes())
            {
                nearContact_[cell] = true;
            }
        }
    }
}


template<int D>
void Foam::materialPointMethod::touch()
{
    if (!contact_)
    {
        return;
    }

    const pointSet& p = points_;
    findTouching<D>();
    setZero(inward_);

    forAll(p.x, i)
    {
        const splineStencil<D> stencil(grid_, p.x[i]);

        if (nearContact_[stencil.cell()])
        {
            lanes slope[D];
            for (int k = 0; k < D; ++k)
            {
                slope[k] = lanes::Zero();
                slope[k][k + 1] = -p.volume[i];
            }
            stencil.add
            (
                inward_[fieldOf(i)], lanes(p.volume[i], 0, 0, 0), slope
            );
        }
    }

    sumShared(grid_, inward_);
    contact_->apply(nodes_, inward_, grid_.cubeVolume(grid_.h()), touching_);
}


template void Foam::materialPointMethod::touch<2>();
template void Foam::materialPointMethod::touch<3>();
