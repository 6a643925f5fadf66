// SPDX-License-Identifier: GPL-3.0-or-later
// A rotational drag law at a strength between 0 and 1.

#include "scaledRotationalDrag.H"

Foam::scaledRotationalDrag::scaledRotationalDrag
(
    const scalar s,
    autoPtr<rotationalDragModel>&& model
)
:
    strength_(s),
    model_(std::move(model))
{}


Foam::scalar
Foam::scaledRotationalDrag::coefficient(const grainState& state) const
{
    return strength_*model_->coefficient(state);
}
