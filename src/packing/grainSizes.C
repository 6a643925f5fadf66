// SPDX-License-Identifier: GPL-3.0-or-later
// Grain sizes of a packing: one diameter, or several by mass fraction.

#include "grainSizes.H"
#include "mathematicalConstants.H"
#include "Tuple2.H"

Foam::grainSizes::grainSizes(const dictionary& dict)
:
    diameters_(),
    massFractions_()
{
    if (dict.found("diameter") == dict.found("diameters"))
    {
        FatalIOErrorInFunction(dict)
            << "Give either diameter (one size, in m) or diameters (a table"
            << " of size and mass fraction), not both and not none"
            << exit(FatalIOError);
    }

    if (dict.found("diameter"))
    {
        diameters_ = scalarList(1, dict.get<scalar>("diameter"));
        massFractions_ = scalarList(1, 1.0);
    }
    else
    {
        using table = List<Tuple2<scalar, scalar>>;
        for (const auto& row : dict.get<table>("diameters"))
        {
            diameters_.append(row.first());
            massFractions_.append(row.second());
        }
    }

    check(dict);
}


void Foam::grainSizes::check(const dictionary& dict) const
{
    if (diameters_.empty() || min(diameters_) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Grain diameters must be above zero, in m; read "
            << diameters_ << exit(FatalIOError);
    }

    if (mag(sum(massFractions_) - 1) > 1e-6 || min(massFractions_) < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Mass fractions in diameters must not be negative and sum to 1;"
            << " they sum to " << sum(massFractions_) << exit(FatalIOError);
    }
}


Foam::scalarField Foam::grainSizes::forVolume(const scalar solidVolume) const
{
    List<Tuple2<scalar, label>> counts(diameters_.size());
    label total = 0;

    forAll(diameters_, i)
    {
        const scalar one =
            constant::mathematical::pi/6*pow3(diameters_[i]);
        const scalar many = massFractions_[i]*solidVolume/one + 0.5;

        if (many > labelMax/10)
        {
            FatalErrorInFunction
                << many << " grains of " << diameters_[i] << " m would be"
                << " needed for " << solidVolume << " m3 of grains, and "
                << labelMax/10 << " is the most." << nl
                << "    Box, foot and diameter must all be in metres."
                << exit(FatalError);
        }

        const label n = label(many);
        counts[i] = Tuple2<scalar, label>(diameters_[i], n);
        total += n;
    }

    sort
    (
        counts,
        [](const Tuple2<scalar, label>& a, const Tuple2<scalar, label>& b)
        {
            return a.first() > b.first();
        }
    );

    scalarField diameters(total);
    label next = 0;
    for (const auto& size : counts)
    {
        for (label k = 0; k < size.second(); ++k)
        {
            diameters[next++] = size.first();
        }
    }
    return diameters;
}
