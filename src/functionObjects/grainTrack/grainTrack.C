// SPDX-License-Identifier: GPL-3.0-or-later
// Place, velocity and spin of single grains over time.

#include "grainTrack.H"

#include "Map.H"
#include "Tuple2.H"
#include "addToRunTimeSelectionTable.H"
#include "flumeSettings.H"
#include "periodicity.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(grainTrack, 0);
    addToRunTimeSelectionTable(functionObject, grainTrack, dictionary);
}
}


namespace
{

//- Distance from a place [m] and number of a grain
typedef Foam::Tuple2<Foam::scalar, Foam::label> candidate;

//- The nearer one, of equal ones the lower number, on any ranks
struct nearer
{
    candidate operator()(const candidate& a, const candidate& b) const
    {
        return b < a ? b : a;
    }
};

} // End anonymous namespace


Foam::functionObjects::grainTrack::grainTrack
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);

    if (points_.size())
    {
        restore("ids", ids_);
    }
    restore("looked", idsReported_);
    if (writes())
    {
        writeHeaders();
    }
}


void Foam::functionObjects::grainTrack::writeHeaders()
{
    wordList names;

    for (label i = 0; i < max(ids_.size(), points_.size()); ++i)
    {
        for
        (
            const char* c
          : {"id", "x", "y", "z", "Ux", "Uy", "Uz", "wx", "wy", "wz"}
        )
        {
            names.append(word(Foam::name(i) + ":" + c, false));
        }
    }

    writeColumns
    (
        file(),
        "Of each grain: its number (-1: there is none), place in m, velocity in m/s,"
        " spin in rad/s, in coordinates of the flume",
        names
    );
}


bool Foam::functionObjects::grainTrack::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys(dict, {"ids", "points", "types"});

    types_ = labelHashSet(dict.getOrDefault("types", labelList()));
    points_ = dict.getOrDefault("points", pointField());
    const labelList given(dict.getOrDefault("ids", labelList()));

    if (given.empty() == points_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Give either ids, numbers of grains, or points, in m: the grain"
            << " nearest to each at first is followed." << exit(FatalIOError);
    }
    if (given.size())
    {
        ids_ = given;
    }
    const List<vector> shifts(frame_.components(periodicity(mesh_).shifts()));
    forAll(points_, k)
    {
        const point p(frame_.local(points_[k]));
        flumeSettings::checkMeets
        (
            dict, "Point " + Foam::name(k), boundBox(p, p), shifts, box()
        );
    }

    return true;
}


Foam::labelList Foam::functionObjects::grainTrack::nearest() const
{
    const grainSnapshot& all = grains();
    const labelList chosen(ofTypes(all, types_));
    const periodicity images(mesh_);
    labelList ids(points_.size(), -1);

    forAll(points_, k)
    {
        candidate best(GREAT, -1);

        for (const label i : chosen)
        {
            best = nearer()
            (
                best,
                candidate
                (
                    mag(images.shortest(all.position[i] - points_[k])),
                    all.id[i]
                )
            );
        }

        reduce(best, nearer());
        ids[k] = best.second();
    }

    return ids;
}


bool Foam::functionObjects::grainTrack::sample()
{
    if (ids_.empty())
    {
        // The nearest grains are sought once there are grains
        const labelList ids(nearest());
        if (ids.found(-1))
        {
            return false;
        }
        ids_ = ids;
        setProperty("ids", ids_);
    }

    return true;
}


void Foam::functionObjects::grainTrack::reportUnknown(const string& unknown)
{
    // Grains that were found by points exist
    if (idsReported_ || points_.size())
    {
        return;
    }

    const labelList& ids = grains().id;
    const label n = returnReduce(ids.size(), sumOp<label>());
    if (n)
    {
        idsReported_ = true;
        setProperty("looked", idsReported_);
    }

    if (n && unknown.size())
    {
        const label first = gMin(ids);
        const label last = gMax(ids);
        WarningInFunction
            << type() << " " << name() << ": of the " << n << " grains, with ids "
            << first << " to " << last << ", none has one of"
            << unknown.c_str() << nl
            << "    It has left, is yet to come, or the number is wrong; until a grain"
            << " has it, its columns are -1 and zeros." << endl;
    }
}


void Foam::functionObjects::grainTrack::report()
{
    const grainSnapshot& all = grains();
    Map<label> place;
    forAll(all.id, i)
    {
        place.insert(all.id[i], i);
    }

    // Each grain is on one rank: the sum over ranks is its value
    constexpr label n = 10;
    scalarField line(n*ids_.size(), Zero);

    forAll(ids_, k)
    {
        const auto i = place.cfind(ids_[k]);

        if (i.found())
        {
            const vector x(frame_.local(all.position[*i]));
            const vector U(frame_.components(all.U[*i]));
            const vector w(frame_.components(all.omega[*i]));
            const scalarList values
            ({
                ids_[k] + 1.0,
                x.x(), x.y(), x.z(), U.x(), U.y(), U.z(), w.x(), w.y(), w.z()
            });
            SubList<scalar>(line, n, n*k) = values;
        }
    }

    reduce(line, sumOp<scalarField>());
    string unknown;
    forAll(ids_, k)
    {
        line[n*k] -= 1;
        if (line[n*k] < 0)
        {
            unknown += " " + Foam::name(ids_[k]);
        }
    }
    reportUnknown(unknown);

    if (writes())
    {
        writeLine(file(), line);
    }
}
