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
#include <sstream>

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

    ++looks_;
    const label nSeen = origins_.size();
    DynamicList<record> mine;
    for (const List<record>& some : swapLists(toRanks))
    {
        for (record r : some)
        {
            origin& first =
                origins_(r.id, origin{r.x, clock_.value(), r.d, r.type});
            first.look = looks_;
            r.origin = first.x;
            r.displacement = images_.shortest(r.x - r.origin);
            mine.append(r);
        }
    }

    hasNew_ = hasNew_ || origins_.size() > nSeen;
    return mine;
}


Foam::DynamicList<Foam::grainOrigins::record> Foam::grainOrigins::ofAbsent() const
{
    DynamicList<record> away;
    forAllConstIters(origins_, iter)
    {
        const origin& o = iter.val();
        if (o.look != looks_ && o.since <= now())
        {
            away.append
            (
                record{iter.key(), o.type, o.x, Zero, o.d, o.x, Zero}
            );
        }
    }

    return away;
}


void Foam::grainOrigins::write(const fileName& file)
{
    std::ostringstream mine;
    mine << std::setprecision(17);
    for (const label id : origins_.sortedToc())
    {
        const origin& o = origins_[id];
        mine<< id << ' ' << o.x.x() << ' ' << o.x.y() << ' ' << o.x.z() << ' '
            << o.since << ' ' << o.d << ' ' << o.type << '\n';
    }
    const label n = returnReduce(origins_.size(), sumOp<label>());
    hasNew_ = false;

    if (!Pstream::master())
    {
        OPstream(Pstream::commsTypes::scheduled, Pstream::masterNo())()
            << string(mine.str());
        return;
    }

    mkDir(file.path());
    const fileName aside(file + ".incomplete");
    std::ofstream os(aside);
    os  << std::setprecision(17) << time << ' ' << d << ' ' << n << '\n';
    os  << mine.str();
    for (label rank = 1; rank < Pstream::nProcs(); ++rank)
    {
        os  << string(IPstream(Pstream::commsTypes::scheduled, rank)());
    }

    os.close();
    if (!os || !mv(aside, file))
    {
        FatalErrorInFunction
            << "Cannot write " << file << nl << "    Is the disk full?"
            << exit(FatalError);
    }
}


Foam::scalar Foam::grainOrigins::now() const
{
    // Half a step: a time folder's name has fewer digits than the time
    return clock_.value() + clock_.deltaTValue()/2;
}


void Foam::grainOrigins::readGrains
(
    std::istream& is,
    const label n,
    const fileName& file
)
{
    // Written times are all sampled, and a later grain is not seen before its time
    const scalar last = functionObject::postProcess ? GREAT : now();

    for (label i = 0; i < n; ++i)
    {
        label id = -1;
        origin o;

        if
        (
           !(
                is >> id >> o.x.x() >> o.x.y() >> o.x.z() >> o.since >> o.d
                   >> o.type
            )
        )
        {
            FatalErrorInFunction
                << file << " has " << i << " of the " << n
                << " grains that its first line announces: it was cut off, or an"
                << " earlier version wrote it without diameters and types." << nl
                << "    Restore the whole file; or remove it, and displacements"
                << " are measured from now on." << exit(FatalError);
        }
        if (id % Pstream::nProcs() == Pstream::myProcNo() && o.since <= last)
        {
            origins_.set(id, o);
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
