// SPDX-License-Identifier: GPL-3.0-or-later
// Shares of spheres in the cells that they reach, on this rank and others.

#include "cellWeights.H"

#include "mathematicalConstants.H"
#include "swapLists.H"

namespace
{
    Foam::scalar volumeOf(const Foam::scalar radius)
    {
        return 4*Foam::constant::mathematical::pi/3*Foam::pow3(radius);
    }
}


void Foam::cellWeights::addSphere
(
    const point& centre,
    const scalar radius,
    const label cell
)
{
    const scalar volume = volumeOf(radius);
    const sphereOverlap::cap cap(overlap_.capOf(centre, radius, cell));

    // Most spheres are within one cell or cut by one face
    if (cap.known)
    {
        add(cell, 1 - cap.volume/volume);
        if (cap.behind >= 0)
        {
            add(cap.behind, cap.volume/volume);
        }
        return;
    }

    here_.clear();
    exits_.clear();
    here_.append(sphereOverlap::piece{cell, centre, volume});
    overlap_.flood(radius, 0, here_, exits_);

    for (const sphereOverlap::piece& p : here_)
    {
        add(p.cell, p.volume/volume);
    }

    if (exits_.empty())
    {
        normalise(start_.last(), slots_.size());
    }
    else
    {
        const label grain = nGrains();
        pieces_.insert(labelPair(Pstream::myProcNo(), grain), here_);
        reach(radius, Pstream::myProcNo(), grain);
    }
}


void Foam::cellWeights::reach
(
    const scalar radius,
    const label homeRank,
    const label grain
)
{
    for (const sphereOverlap::exit& e : exits_)
    {
        reaching_[e.to.rank].append
        (
            sphere{e.centre, radius, e.to.cell, homeRank, grain}
        );
    }
}


void Foam::cellWeights::flood(const sphere& s, DynamicList<part>& answer)
{
    auto& pieces = pieces_(labelPair(s.homeRank, s.grain));
    const label first = pieces.size();

    // It may come through several faces
    if (sphereOverlap::find(pieces, s.cell, s.centre, s.radius) != first)
    {
        return;
    }

    exits_.clear();
    pieces.append(sphereOverlap::piece{s.cell, s.centre, 0});
    overlap_.flood(s.radius, first, pieces, exits_);
    reach(s.radius, s.homeRank, s.grain);

    for (label i = first; i < pieces.size(); ++i)
    {
        answer.append
        (
            part
            {
                s.grain,
                Pstream::myProcNo(),
                pieces[i].cell,
                pieces[i].volume/volumeOf(s.radius)
            }
        );
    }
}


Foam::DynamicList<Foam::cellWeights::part> Foam::cellWeights::followSpheres()
{
    DynamicList<part> home;

    for (;;)
    {
        label n = 0;

        for (const DynamicList<sphere>& toRank : reaching_)
        {
            n += toRank.size();
        }

        if (!returnReduce(n, sumOp<label>()))
        {
            return home;
        }

        List<DynamicList<part>> answers(Pstream::nProcs());

        for (const List<sphere>& from : swapLists(reaching_))
        {
            for (const sphere& s : from)
            {
                flood(s, answers[s.homeRank]);
            }
        }

        for (const List<part>& from : swapLists(answers))
        {
            home.append(from);
        }
    }
}


void Foam::cellWeights::insert
(
    const UList<part>& parts,
    DynamicList<arrival>& arrivals
)
{
    if (parts.empty())
    {
        return;
    }

    labelList more(nGrains(), Zero);
    for (const part& p : parts)
    {
        ++more[p.grain];
    }

    // Make room behind the entries of each grain, the last grain first
    label gap = parts.size();
    slots_.setSize(slots_.size() + gap);
    weights_.setSize(slots_.size());

    for (label grain = nGrains() - 1; gap; --grain)
    {
        const label first = start_[grain];
        const label end = start_[grain + 1];

        start_[grain + 1] += gap;
        gap -= more[grain];

        for (label i = end - 1; i >= first; --i)
        {
            slots_[i + gap] = slots_[i];
            weights_[i + gap] = weights_[i];
        }
    }

    for (const part& p : parts)
    {
        const label at = start_[p.grain + 1] - more[p.grain]--;

        weights_[at] = p.share;
        arrivals.append(arrival{at, p.rank, p.cell});
    }

    forAllConstIters(pieces_, iter)
    {
        if (iter.key().first() == Pstream::myProcNo())
        {
            const label grain = iter.key().second();
            normalise(start_[grain], start_[grain + 1]);
        }
    }
}


void Foam::cellWeights::normalise(const label first, const label end)
{
    if (end == first + 1)
    {
        weights_[first] = 1;
        return;
    }

    // Next to a face that is not flat the centre may have been taken for one
    // of the cell in front of it, which comes first, and be in the one behind
    if (weights_[first] > 1 + 1e-9)
    {
        label least = first;
        for (label i = first; i < end; ++i)
        {
            least = weights_[i] < weights_[least] ? i : least;
        }
        weights_[first] -= 1;
        weights_[least] += 1;
    }

    scalar sum = 0;
    for (label i = first; i < end; ++i)
    {
        weights_[i] = max(weights_[i], scalar(0));
        sum += weights_[i];
    }
    for (label i = first; i < end; ++i)
    {
        weights_[i] /= sum;
    }
}
