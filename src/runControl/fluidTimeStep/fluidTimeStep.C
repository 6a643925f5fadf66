// SPDX-License-Identifier: GPL-3.0-or-later
// The time step of the fluid that its Courant numbers allow.

#include "fluidTimeStep.H"

void Foam::fluidTimeStep::adjust
(
    const scalar ratio,
    const scalar deltaT,
    const scalar maxDeltaT
)
{
    const scalar largest = min(1.0 + 0.1*ratio, 1.2)*allowed_;

    allowed_ = min(min(ratio*deltaT, largest), maxDeltaT);
}
