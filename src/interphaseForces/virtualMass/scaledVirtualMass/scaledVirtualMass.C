// SPDX-License-Identifier: GPL-3.0-or-later
// A virtual mass law at a strength between 0 and 1.

#include "scaledVirtualMass.H"

Foam::scaledVirtualMass::scaledVirtualMass
(
    const scalar s,
    autoPtr<virtualMassModel>&& model
)
:
    strength_(s),
    model_(std::move(model))
{}


Foam::scalar
Foam::scaledVirtualMass::coefficient(const grainState& state) const
{
    return strength_*model_->coefficient(state);
}
