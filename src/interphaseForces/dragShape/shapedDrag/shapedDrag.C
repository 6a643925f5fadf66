// SPDX-License-Identifier: GPL-3.0-or-later
// Any drag law for grains that are not spheres.

#include "shapedDrag.H"
#include "standardDrag.H"

void Foam::shapedDrag::check(const dictionary& dict) const
{
    if (!(sphericity_ > 0 && sphericity_ <= 1))
    {
        FatalIOErrorInFunction(dict)
            << "The shape of the grains in the drag has the sphericity "
            << sphericity_ << nl
            << "    It is the surface of the sphere of the same volume over that of"
            << " the grain: above 0, at most 1. Crushed rock has 0.6 to 0.8."
            << exit(FatalIOError);
    }
    if (!(crosswiseSphericity_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "The shape of the grains in the drag has the crosswiseSphericity "
            << crosswiseSphericity_ << nl
            << "    It is the cross section of the sphere of the same volume over the"
            << " area of the grain across the slip: above 0. Leave it out for"
            << " grains that lie in all directions." << exit(FatalIOError);
    }
    if (diameters_.first() > diameters_.second())
    {
        FatalIOErrorInFunction(dict)
            << "The shape of the grains in the drag holds for the diameters "
            << diameters_ << " m: the smallest comes first" << exit(FatalIOError);
    }
}


Foam::scalar Foam::shapedDrag::factor(const grainState& state) const
{
    if (state.d < diameters_.first() || state.d > diameters_.second())
    {
        return 1;
    }

    const scalar Re = state.voidFraction*standardDrag::slipReynolds(state);

    return
        1
      + shape_.strength()
       *(shape_.law().factor(Re, sphericity_, crosswiseSphericity_) - 1);
}


Foam::shapedDrag::shapedDrag
(
    autoPtr<dragModel>&& law,
    const dictionary& dict
)
:
    law_(std::move(law)),
    shape_
    (
        closure::without(dict, {"sphericity", "crosswiseSphericity", "diameters"})
    ),
    sphericity_
    (
        dict.get<word>("model") == "none"
      ? dict.getOrDefault<scalar>("sphericity", 1)
      : dict.get<scalar>("sphericity")
    ),
    crosswiseSphericity_
    (
        dict.getOrDefault("crosswiseSphericity", sphericity_)
    ),
    diameters_
    (
        dict.getOrDefault("diameters", Tuple2<scalar, scalar>(0, GREAT))
    )
{
    check(dict);
}


Foam::autoPtr<Foam::dragModel> Foam::shapedDrag::New
(
    autoPtr<dragModel>&& law,
    const dictionary& dict
)
{
    if (!dict.found("shape"))
    {
        return autoPtr<dragModel>(std::move(law));
    }

    // Made, and with that checked, also where it does nothing
    autoPtr<shapedDrag> shaped
    (
        new shapedDrag
        (
            std::move(law),
            keywords::sub
            (
                dict,
                "shape",
                {
                    "model", "sphericity", "crosswiseSphericity", "diameters",
                    "strength"
                }
            )
        )
    );

    if (!shaped->shape_.isOn() || !shaped->law_.valid())
    {
        return std::move(shaped->law_);
    }
    return autoPtr<dragModel>(shaped.release());
}


Foam::scalar Foam::shapedDrag::K(const grainState& state) const
{
    return law_->K(state)*factor(state);
}


void Foam::shapedDrag::K
(
    const UList<grainState>& states,
    UList<scalar>& K
) const
{
    law_->K(states, K);

    forAll(states, i)
    {
        K[i] *= factor(states[i]);
    }
}
