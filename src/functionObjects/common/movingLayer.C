// SPDX-License-Identifier: GPL-3.0-or-later
// Where, over height, grains that rest end and grains that move begin.

#include "movingLayer.H"

Foam::movingLayer::movingLayer
(
    const scalar bottom,
    const scalar top,
    const scalar thickness
)
:
    resting_(bottom, top, thickness),
    moving_(resting_)
{}


void Foam::movingLayer::add
(
    const scalar z,
    const scalar r,
    const scalar volume,
    const bool moves
)
{
    (moves ? moving_ : resting_).addSphere(z, r, volume);
}


void Foam::movingLayer::reduce()
{
    resting_.reduce();
    moving_.reduce();
}


Foam::scalar Foam::movingLayer::surface() const
{
    // At the bottom all that rests is above
    scalar wrong = sum(resting_.values());
    const scalar all = wrong + sum(moving_.values());
    scalar least = wrong;
    scalar surface = resting_.start();

    forAll(resting_.values(), i)
    {
        wrong += moving_.values()[i] - resting_.values()[i];

        // Rounding does not count as less
        if (wrong < least - 1e-9*all)
        {
            least = wrong;
            surface = resting_.start() + (i + 1)*resting_.width();
        }
    }

    return surface;
}
