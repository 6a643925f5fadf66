// SPDX-License-Identifier: GPL-3.0-or-later
// Where each grain was at first, whatever rank it is on.

#include "grainOrigins.H"

#include "IPstream.H"
#include "OPstream.H"
#include "OSspecific.H"
#include "foamCompatibility.H"
#include "swapLists.H"

#include <fstream>
#include <iomanip>

Foam::grainOrigins::grainOrigins(const polyMesh& mesh)
:
    images_(mesh)
{}


Foam::DynamicList<Foam::grainOrigins::record> Foam::grainOrigins::of
(
    const grainSnapshot& grains,
    const labelList& chosen
)
{
    List<DynamicList<record>> toRanks(Pstream::nProcs());

    for (const label i : chosen)
    {
        toRanks[grains.id[i] % Pstream::nProcs()].append
        (
            record
            {
                grains.id[i], grains.type[i], grains.position[i], grains.U[i],
                grains.d[i], Zero, Zero
            }
        );
    }

    DynamicList<record> mine;
    for (const List<record>& some : swapLists(toRanks))
    {
        for (record r : some)
        {
            if (!origins_.found(r.id))
            {
                origins_.insert(r.id, r.x);
            }
            r.origin = origins_[r.id];
            r.displacement = images_.shortest(r.x - r.origin);
            mine.append(r);
        }
    }

    return mine;
}


void Foam::grainOrigins::write(const fileName& file) const
{
    const labelList ids(origins_.sortedToc());
    pointField places(ids.size());
    forAll(ids, i)
    {
        places[i] = origins_[ids[i]];
    }

    if (!Pstream::master())
    {
        OPstream(Pstream::commsTypes::scheduled, Pstream::masterNo())()
            << ids << places;
        return;
    }

    mkDir(file.path());
    std::ofstream os(file);
    os  << std::setprecision(17) << time << '\n';
    const auto add = [&](const labelList& numbers, const pointField& at)
    {
        forAll(numbers, i)
        {
            os  << numbers[i] << ' ' << at[i].x() << ' ' << at[i].y() << ' '
                << at[i].z() << '\n';
        }
    };

    add(ids, places);
    for (label rank = 1; rank < Pstream::nProcs(); ++rank)
    {
        IPstream is(Pstream::commsTypes::scheduled, rank);
        const labelList numbers(is);
        add(numbers, pointField(is));
    }

    if (!os.flush())
    {
        FatalErrorInFunction
            << "Cannot write " << file << nl << "    Is the disk full?"
            << exit(FatalError);
    }
}


bool Foam::grainOrigins::read(const fileName& file)
{
    std::ifstream is(file);
    bool found = bool(is >> time);
    found = returnReduce(found, andOp<bool>());

    if (!found)
    {
        time = GREAT;
        return false;
    }

    label id;
    point p;
    while (is >> id >> p.x() >> p.y() >> p.z())
    {
        if (id % Pstream::nProcs() == Pstream::myProcNo())
        {
            origins_.set(id, p);
        }
    }

    return true;
}
