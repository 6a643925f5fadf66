// SPDX-License-Identifier: GPL-3.0-or-later
// Where each grain was at first, whatever rank it is on.

#include "grainOrigins.H"

#include "IPstream.H"
#include "OPstream.H"
#include "OSspecific.H"
#include "foamCompatibility.H"
#include "functionObject.H"
#include "swapLists.H"

#include <fstream>
#include <iomanip>

Foam::grainOrigins::grainOrigins(const polyMesh& mesh)
:
    clock_(mesh.time()),
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
                origins_.insert
                (
                    r.id, Tuple2<point, scalar>(r.x, clock_.value())
                );
                grown_ = true;
            }
            r.origin = origins_[r.id].first();
            r.displacement = images_.shortest(r.x - r.origin);
            mine.append(r);
        }
    }

    return mine;
}


void Foam::grainOrigins::write(const fileName& file)
{
    const labelList ids(origins_.sortedToc());
    pointField places(ids.size());
    scalarField times(ids.size());
    forAll(ids, i)
    {
        places[i] = origins_[ids[i]].first();
        times[i] = origins_[ids[i]].second();
    }
    const label n = returnReduce(ids.size(), sumOp<label>());
    grown_ = false;

    if (!Pstream::master())
    {
        OPstream(Pstream::commsTypes::scheduled, Pstream::masterNo())()
            << ids << places << times;
        return;
    }

    mkDir(file.path());
    const fileName aside(file + ".incomplete");
    std::ofstream os(aside);
    os  << std::setprecision(17) << time << ' ' << d << ' ' << n << '\n';
    const auto add = [&]
    (
        const labelList& numbers,
        const pointField& at,
        const scalarField& since
    )
    {
        forAll(numbers, i)
        {
            os  << numbers[i] << ' ' << at[i].x() << ' ' << at[i].y() << ' '
                << at[i].z() << ' ' << since[i] << '\n';
        }
    };

    add(ids, places, times);
    for (label rank = 1; rank < Pstream::nProcs(); ++rank)
    {
        IPstream is(Pstream::commsTypes::scheduled, rank);
        const labelList numbers(is);
        const pointField at(is);
        add(numbers, at, scalarField(is));
    }

    os.close();
    if (!os || !mv(aside, file))
    {
        FatalErrorInFunction
            << "Cannot write " << file << nl << "    Is the disk full?"
            << exit(FatalError);
    }
}


void Foam::grainOrigins::readGrains
(
    std::istream& is,
    const label n,
    const fileName& file
)
{
    // Half a step: a time folder's name has fewer digits than the time. Written
    // times are all looked at, and a later grain is not seen before its time
    const scalar now =
        functionObject::postProcess
      ? GREAT : clock_.value() + clock_.deltaTValue()/2;

    for (label i = 0; i < n; ++i)
    {
        label id = -1;
        point p;
        scalar since = 0;

        if (!(is >> id >> p.x() >> p.y() >> p.z() >> since))
        {
            FatalErrorInFunction
                << file << " has " << i << " of the " << n
                << " grains that its first line tells of." << nl
                << "    Bring back the whole file; or remove it, and displacements"
                << " are those from now on." << exit(FatalError);
        }
        if (id % Pstream::nProcs() == Pstream::myProcNo() && since <= now)
        {
            origins_.set(id, Tuple2<point, scalar>(p, since));
        }
    }
}


bool Foam::grainOrigins::read(const fileName& file)
{
    std::ifstream is(file);

    if (!returnReduce(bool(is), andOp<bool>()))
    {
        return false;
    }

    label n = 0;
    if (!(is >> time >> d >> n))
    {
        FatalErrorInFunction
            << "The first line of " << file << " is not the time, the mean"
            << " diameter and the number of grains." << nl
            << "    Bring back the whole file; or remove it, and displacements"
            << " are those from now on." << exit(FatalError);
    }
    readGrains(is, n, file);

    return true;
}
