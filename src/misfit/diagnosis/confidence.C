// SPDX-License-Identifier: GPL-3.0-or-later
// S9: how sure the verdict is.

#include "diagnosis.H"

#include <algorithm>

void Foam::misfit::diagnosis::setPosterior()
{
    for (const weighed& w : found_.explanations)
    {
        found_.posterior.append
        (
            Tuple2<string, scalar>
            (
                told(w.what, mechanismNames()), w.probability
            )
        );
    }
    std::stable_sort
    (
        found_.posterior.begin(),
        found_.posterior.end(),
        [](const auto& a, const auto& b) { return a.second() > b.second(); }
    );
}


bool Foam::misfit::diagnosis::hasAllThatIsNamed(const weighed& w) const
{
    label n = 0;
    for (const label m : w.what.mechanisms)
    {
        n += found_.names.found(mechanismNames()[m]);
    }
    return n && n == found_.names.size();
}


bool Foam::misfit::diagnosis::hasOneOfSet(const weighed& w) const
{
    return
        isAmong(set_, w)
     || std::any_of
        (
            set_.begin(),
            set_.end(),
            [&](const weighed& one)
            {
                return
                    one.what.fault ? w.what.extends(one.what)
                  : w.what.contains(one.what);
            }
        );
}


void Foam::misfit::diagnosis::confide()
{
    scalar sum = 0;
    for (const weighed& w : found_.explanations)
    {
        const word& v = found_.verdict;
        const bool counts =
            v == "none" ? w.what.isNone()
          : found_.blamesChannel()
          ? w.what.fault && w.what.fault->channel() == found_.names[0]
          : v == "unknown" ? w.what.isOnlyUnknown()
          : v == "set" ? hasOneOfSet(w)
          : hasAllThatIsNamed(w);
        sum += counts ? w.probability : 0;
    }

    // 88 of 105 such verdicts were right where the solver made the recordings, the
    // others hid effects that chance could have made (validation/concealed)
    if (found_.verdict == "none" && !passed("detection"))
    {
        sum = max(sum, 0.82);
    }

    // 15 of 17 such names were right there, and 88 of 88 of the others
    if (found_.verdict == "named" && hasMore())
    {
        sum = min(sum, 0.88);
    }

    // Of six such sets there one held the cause
    bool physics = false;
    for (const weighed& w : rivals())
    {
        physics = physics || w.what.mechanisms.size();
    }
    if (found_.verdict == "set" && physics && !isConfirmed())
    {
        sum = min(sum, 0.25);
    }

    // Of 13 that hang on a channel ten: three of six there, seven of seven from the
    // bank
    if (found_.verdict == "set" && physics && !passed("stability"))
    {
        sum = min(sum, 0.77);
    }

    // 37 of 44 such verdicts were right where the solver made the recordings,
    // 30 of 61 from the bank (validation/concealed). Not where runs are missing.
    const bool asked = never_.empty() && found_.failedRuns.empty();
    if (found_.verdict == "unknown" && asked && !isUnproved())
    {
        sum = max(sum, 0.7);
    }
    found_.confidence = min(sum, settings_.ceiling);
}
