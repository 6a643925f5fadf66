// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of a bed under a flow.

#include "bedLayers.H"

#include "PstreamReduceOps.H"

namespace
{

//- From sums on this rank to means over all
void finish(Foam::bedLayer& layer)
{
    Foam::reduce(layer.n, Foam::sumOp<Foam::scalar>());
    Foam::reduce(layer.volume, Foam::sumOp<Foam::scalar>());
    Foam::reduce(layer.U, Foam::sumOp<Foam::scalar>());
    layer.U /= Foam::max(layer.volume, Foam::VSMALL);
}

} // End anonymous namespace


Foam::bedLayers::bedLayers
(
    const bedGrains& bed,
    const scalar x1,
    const scalar x2,
    const scalar bouncingSpeed,
    const scalar creepingSpeed
)
{
    forAll(bed.d, i)
    {
        const scalar x = bed.centre[i].x();

        if (x >= x1 && x <= x2)
        {
            const scalar speed = mag(bed.U[i]);
            bedLayer& layer =
                speed > bouncingSpeed ? bouncing
              : speed > creepingSpeed ? creeping
              : stationary;

            layer.n += bed.partOfBody[i];
            layer.volume += bed.volume[i];
            layer.U += bed.volume[i]*bed.U[i].x();
        }
    }

    finish(bouncing);
    finish(creeping);
    finish(stationary);

    UMoving =
        (bouncing.volume*bouncing.U + creeping.volume*creeping.U)
       /max(bouncing.volume + creeping.volume, VSMALL);
}
