// SPDX-License-Identifier: GPL-3.0-or-later
// A lift law at a strength between 0 and 1.

#include "scaledLift.H"

Foam::scaledLift::scaledLift
(
    const scalar s,
    autoPtr<liftModel>&& model
)
:
    strength_(s),
    model_(std::move(model))
{}


Foam::vector Foam::scaledLift::force(const grainState& state) const
{
    return strength_*model_->force(state);
}
