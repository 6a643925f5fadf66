// SPDX-License-Identifier: GPL-3.0-or-later
// Grains computed by LIGGGHTS: those that are missing, and where they went.

#include "liggghtsOutlet.H"

#include "OStringStream.H"
#include "clumpRemoval.H"
#include "foamCompatibility.H"


std::string Foam::liggghtsOutlet::describe
(
    const lostGrainFinder::record& grain,
    const label clump
)
{
    if (grain.first() < 0)
    {
        return "It came in within this exchange interval, too.";
    }

    OStringStream os;
    os  << "Grain " << grain.first() << " was, one exchange interval before, at "
        << grain.second().first() << " m with velocity "
        << grain.second().second() << " m/s.";
    if (clump)
    {
        os  << " It is a sphere of clump " << clump << ", which counts once.";
    }
    return os.str();
}


void Foam::liggghtsOutlet::warnOfVanished
(
    const label n,
    const lostGrainFinder::record& first,
    const label clump
)
{
    warnedOfVanished_ = true;

    WarningInFunction
        << n << " grains (reported once) are gone by time "
        << grains_.timeName() << " s that were not about to reach a side"
        << " of their box; they are lost, and do not count as left." << nl
        << "    " << describe(first, clump).c_str() << nl
        << "    A command of the case took them away, or a contact threw them"
        << " out: then shorten the DEM step." << endl;
}


void Foam::liggghtsOutlet::stopForWrong
(
    const label n,
    const lostGrainFinder::record& first,
    const label clump
) const
{
    FatalErrorInFunction
        << "A grain left the mesh where it may not, by time "
        << grains_.timeName() << " s." << nl
        << "    " << describe(first, clump).c_str() << nl
        << "    " << n << " of " << nGrains_ << " grains left so." << nl
        << "    If grains pass a wall: shorten the DEM step or make the"
        << " grains stiffer. If they may leave: name the patches in"
        << " LIGGGHTS/outflow of constant/granularProperties."
        << exit(FatalError);
}


Foam::labelList Foam::liggghtsOutlet::clumpsOf
(
    const UList<lostGrainFinder::record>& missing
) const
{
    labelList result(missing.size(), Zero);

    forAll(missing, k)
    {
        const auto known = clumpBefore_.cfind(missing[k].first());
        result[k] = known.found() ? *known : 0;
    }
    Pstream::listCombineGather(result, maxEqOp<label>());
    compatibility::broadcast(result);

    return result;
}


Foam::List<Foam::lostGrainFinder::record> Foam::liggghtsOutlet::missingOnce
(
    labelList& clumps
) const
{
    List<lostGrainFinder::record> missing(before_.missing(grains_.id()));
    clumps = clumpsOf(missing);
    labelHashSet seen;
    label n = 0;

    forAll(missing, k)
    {
        if (!clumps[k] || seen.insert(clumps[k]))
        {
            missing[n] = missing[k];
            clumps[n] = clumps[k];
            ++n;
        }
    }
    missing.setSize(n);
    clumps.setSize(n);

    return missing;
}


bool Foam::liggghtsOutlet::cameToSide
(
    const lostGrainFinder::record& grain,
    const label clump,
    point& leavesAt,
    vector& velocity
) const
{
    velocity = grain.second().second();
    leavesAt = grain.second().first();
    if (!clump)
    {
        return cameToSide(grain.second().first(), velocity, leavesAt);
    }

    // Known from when it was taken out
    const auto departed = removal_->departed().cfind(clump);
    if (departed.found())
    {
        leavesAt = (*departed).first();
        velocity = (*departed).second();
    }
    return departed.found();
}


Foam::label Foam::liggghtsOutlet::nVanished(const label gone)
{
    // Those that came in and went within one interval were never seen
    labelList clumps;
    const List<lostGrainFinder::record> missing(missingOnce(clumps));
    const label nUnseen = gone - missing.size();
    label nWrong = openings_.empty() ? nUnseen : 0;
    label nInside = nUnseen - nWrong;
    lostGrainFinder::record first(-1, Pair<vector>());
    lostGrainFinder::record firstInside(first);
    label firstClump = 0;
    label firstClumpInside = 0;

    forAll(missing, k)
    {
        const lostGrainFinder::record& grain = missing[k];
        point leavesAt;
        vector velocity;
        const bool out = cameToSide(grain, clumps[k], leavesAt, velocity);

        if (out ? !mayLeave(leavesAt, velocity) : openings_.empty())
        {
            ++nWrong;
            firstClump = first.first() < 0 ? clumps[k] : firstClump;
            first = first.first() < 0 ? grain : first;
        }
        else if (!out)
        {
            ++nInside;
            firstClumpInside = firstInside.first() < 0 ? clumps[k] : firstClumpInside;
            firstInside = firstInside.first() < 0 ? grain : firstInside;
        }
    }

    if (nInside > 0 && !warnedOfVanished_ && Pstream::master())
    {
        warnOfVanished(nInside, firstInside, firstClumpInside);
    }

    if (nWrong && Pstream::master())
    {
        stopForWrong(nWrong, first, firstClump);
    }

    // Until the master has ended the run
    compatibility::barrier();

    return nInside;
}
