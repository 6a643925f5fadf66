// SPDX-License-Identifier: GPL-3.0-or-later
// Any drag law times a factor from a table over void fraction and Reynolds
// number.

#include "correctedDrag.H"

#include "closure.H"
#include "standardDrag.H"

void Foam::correctedDrag::place
(
    const scalarList& nodes,
    const scalar x,
    label& before,
    scalar& share
)
{
    before = 0;
    while (before < nodes.size() - 2 && x > nodes[before + 1])
    {
        ++before;
    }
    share = 0;
    if (nodes.size() > 1)
    {
        const scalar length = nodes[before + 1] - nodes[before];
        share = min(max((x - nodes[before])/length, scalar(0)), scalar(1));
    }
}


void Foam::correctedDrag::check(const dictionary& dict) const
{
    keywords::check
    (
        dict, {"voidFraction", "Reynolds", "logarithm", "strength", "diameters"}
    );
    if (diameters_.first() > diameters_.second())
    {
        FatalIOErrorInFunction(dict)
            << "The correction of the drag holds for the diameters " << diameters_
            << " m: the smallest comes first" << exit(FatalIOError);
    }

    bool fits = table_.size() == voidFraction_.size() && table_.size();
    for (const scalarList& row : table_)
    {
        fits = fits && row.size() == logReynolds_.size() && row.size();
    }
    for (const scalar logRe : logReynolds_)
    {
        fits = fits && logRe > -GREAT;
    }
    for (label i = 1; i < voidFraction_.size(); ++i)
    {
        fits = fits && voidFraction_[i] > voidFraction_[i - 1];
    }
    for (label i = 1; i < logReynolds_.size(); ++i)
    {
        fits = fits && logReynolds_[i] > logReynolds_[i - 1];
    }

    if (!fits)
    {
        FatalIOErrorInFunction(dict)
            << "The correction of the drag has " << voidFraction_.size()
            << " void fractions, " << logReynolds_.size()
            << " Reynolds numbers and the table " << table_ << '.' << nl
            << "    Nodes must rise, Reynolds numbers be above zero, and"
            << " logarithm have a row for each void fraction with a number for"
            << " each Reynolds number." << exit(FatalIOError);
    }
}


Foam::correctedDrag::correctedDrag
(
    autoPtr<dragModel>&& law,
    const dictionary& dict
)
:
    law_(std::move(law)),
    strength_(dict.getOrDefault<scalar>("strength", 1)),
    voidFraction_(dict.get<scalarList>("voidFraction")),
    logReynolds_(dict.get<scalarList>("Reynolds")),
    table_(dict.get<List<scalarList>>("logarithm")),
    diameters_
    (
        dict.getOrDefault("diameters", Tuple2<scalar, scalar>(0, GREAT))
    )
{
    for (scalar& Re : logReynolds_)
    {
        Re = Re > 0 ? std::log(Re) : -GREAT;
    }
    check(dict);
}


Foam::autoPtr<Foam::dragModel> Foam::correctedDrag::New
(
    autoPtr<dragModel>&& law,
    const dictionary& dict
)
{
    if (!dict.found("correction"))
    {
        return autoPtr<dragModel>(std::move(law));
    }

    // Made, and with that checked, also where it does nothing
    const dictionary correction(keywords::sub(dict, "correction"));
    autoPtr<correctedDrag> corrected
    (
        new correctedDrag(std::move(law), correction)
    );

    if (corrected->strength_ == 0 || !corrected->law_.valid())
    {
        return std::move(corrected->law_);
    }
    return autoPtr<dragModel>(corrected.release());
}


Foam::scalar Foam::correctedDrag::logarithm
(
    const scalar voidFraction,
    const scalar Reynolds
) const
{
    label row, column;
    scalar down, across;
    place(voidFraction_, voidFraction, row, down);
    place
    (
        logReynolds_, standardDrag::finiteLog(Reynolds), column, across
    );

    const auto along = [&](const label r)
    {
        const scalarList& values = table_[r];
        return
            across > 0
          ? (1 - across)*values[column] + across*values[column + 1]
          : values[column];
    };

    return down > 0 ? (1 - down)*along(row) + down*along(row + 1) : along(row);
}


Foam::scalar Foam::correctedDrag::K(const grainState& state) const
{
    if (state.d < diameters_.first() || state.d > diameters_.second())
    {
        return law_->K(state);
    }
    return
        law_->K(state)
       *std::exp
        (
            strength_
           *logarithm(state.voidFraction, standardDrag::slipReynolds(state))
        );
}
