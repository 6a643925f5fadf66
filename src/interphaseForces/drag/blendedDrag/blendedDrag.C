// SPDX-License-Identifier: GPL-3.0-or-later
// A drag law between two others: what a strength between 0 and 1 makes.

#include "blendedDrag.H"

Foam::blendedDrag::blendedDrag
(
    const scalar s,
    autoPtr<dragModel>&& base,
    autoPtr<dragModel>&& model
)
:
    strength_(s),
    base_(std::move(base)),
    model_(std::move(model))
{}


Foam::scalar Foam::blendedDrag::K(const grainState& state) const
{
    return
        (base_.valid() ? (1 - strength_)*base_->K(state) : 0)
      + (model_.valid() ? strength_*model_->K(state) : 0);
}
