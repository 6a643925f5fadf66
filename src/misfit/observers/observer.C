// SPDX-License-Identifier: GPL-3.0-or-later
// What a run measures for a channel, and how its results are read.

#include "observer.H"
#include "keywords.H"
#include "numberTable.H"

#include "HashTable.H"

#include <map>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Fatal if the channel has no place
void requirePlace(const channel& c)
{
    if (!c.samples.hasPlace)
    {
        FatalIOErrorInFunction(c.simulated)
            << "The channel " << c.name << " is observed at a point, but has"
            << " no place: give  place (x y z);  in metres"
            << exit(FatalIOError);
    }
}


//- Entries of a function object that probes a field at the places of an observer, by
//  OpenFOAM's probes and patchProbes
dictionary probes(const observer& o, const word& field)
{
    dictionary dict;
    dict.add("type", word(o.patches.empty() ? "probes" : "patchProbes"));
    dict.add("libs", List<fileName>(1, fileName("libsampling.so")));
    dict.add("fields", wordList(1, field));
    dict.add("probeLocations", o.places);
    if (o.patches.size())
    {
        dict.add("patches", o.patches);
    }
    dict.add("writeControl", word("timeStep"));
    dict.add
    (
        "writeInterval", o.of.simulated.getOrDefault<label>("interval", 1)
    );
    return dict;
}


//- The field at the place of the channel; on a patch, if one is named, at its point that
//  is nearest
void observeProbe(observer& o)
{
    const channel& c = o.of;
    const dictionary& dict = c.simulated;
    requirePlace(c);

    const word field(dict.get<word>("field"));
    const bool hasDirection = dict.found("component");
    const label component =
        !hasDirection ? 0
      : keywords::choice
        (
            dict, "component", "component", wordList({"x", "y", "z"})
        )[0] - 'x';

    o.places = pointField(1, c.place());
    if (dict.found("patch"))
    {
        o.patches = wordList(1, dict.get<word>("patch"));
    }
    o.measured = probes(o, field);
    o.read = [=, &c](const fileName& caseFolder)
    {
        const numberTable table(writtenTable(caseFolder, c.name, field));
        if (table.notFound)
        {
            FatalErrorInFunction
                << "The channel " << c.name << " is at " << c.place()
                << ", which is outside the mesh. Correct its place, or name the wall"
                << " that it is on:  patch <name>;" << exit(FatalError);
        }
        if (!hasDirection && table.rows[0].size() > 2)
        {
            FatalErrorInFunction
                << "The channel " << c.name << " observes the field " << field
                << ", which has directions: name one,  component x;  (or y, z)"
                << exit(FatalError);
        }

        return series(table.column(0), table.column(1 + component));
    };
}


//- Integral of the share of water along a line from the place of the channel, by points
//  that lie evenly on it [m]. Drops above the surface count with what they hold
void observeLevel(observer& o)
{
    const channel& c = o.of;
    const dictionary& dict = c.simulated;
    requirePlace(c);

    const word field(dict.getOrDefault<word>("field", "alpha.water"));
    const vector span(dict.get<point>("end") - c.place());
    const label n = dict.getOrDefault<label>("points", 100);
    if (n < 2 || mag(span) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << "The level " << c.name << " needs a line: two points or more,"
            << " and an end that is not its place" << exit(FatalIOError);
    }

    o.places.resize(n);
    forAll(o.places, i)
    {
        o.places[i] = c.place() + (i + 0.5)/n*span;
    }
    o.measured = probes(o, field);
    o.read = [=, &c](const fileName& caseFolder)
    {
        const numberTable table(writtenTable(caseFolder, c.name, field));
        if (table.notFound)
        {
            FatalErrorInFunction
                << "The line of the level " << c.name << " from "
                << c.place() << " by " << span
                << " leaves the mesh. Correct place or end" << exit(FatalError);
        }

        scalarField sum(table.rows.size(), 0);
        for (label p = 0; p < n; ++p)
        {
            sum += table.column(1 + p);
        }
        return series(table.column(0), sum/n*mag(span));
    };
}


//- A column of postProcessing/<function>/<startTime>/<file> over that of times. For a
//  channel over a distance: postProcessing/<function>/<time>/<file> of the time nearest
//  to that of the channel, the columns of distance and value
void observeTable(observer& o)
{
    const channel& c = o.of;
    const dictionary& dict = c.simulated;
    const word function(dict.get<word>("function"));
    const fileName file(dict.get<fileName>("file"));
    const string xColumn(columnIn(dict, "xColumn", "1"));
    const string yColumn(columnIn(dict, "column", "2"));

    o.read = [=, &c](const fileName& caseFolder)
    {
        const numberTable table
        (
            c.overTime()
          ? writtenTable(caseFolder, function, file)
          : writtenTable(nearestTimeFolder(caseFolder, function, c.at)/file)
        );
        const scalarList x(table.column(table.find(xColumn)));
        const scalarList y(table.column(table.find(yColumn)));
        if (c.isNumber())
        {
            return series({0.0}, {y.last()});
        }

        series s;
        forAll(x, i)
        {
            if (s.x.empty() || x[i] > s.x.last())
            {
                s.x.append(x[i]);
                s.y.append(y[i]);
            }
        }
        return s;
    };
}


//- The surface of the water over a distance, from the table of cells that a sideView of
//  the case writes at the time of the channel: the depth is the share of water in a
//  column of cells times the height of the mesh. For meshes of upright columns
void observeProfile(observer& o)
{
    const channel& c = o.of;
    const word function(c.simulated.get<word>("function"));
    const scalar height = c.simulated.get<scalar>("height");
    if (height <= 0)
    {
        FatalIOErrorInFunction(c.simulated)
            << "The channel " << c.name << " has the height " << height
            << " m. Give that of the mesh, above zero" << exit(FatalIOError);
    }
    if (c.overTime())
    {
        FatalIOErrorInFunction(c.simulated)
            << "The channel " << c.name << " is a profile, and runs over a"
            << " distance: give the time of it,  at <seconds>;"
            << exit(FatalIOError);
    }

    o.read = [=, &c](const fileName& caseFolder)
    {
        const numberTable cells
        (
            writtenTable(nearestTimeFolder(caseFolder, function, c.at)/"cells.dat")
        );
        // The columns of a sideView: x y z size alpha speed
        const scalarList x(cells.column(0));
        const scalarList size(cells.column(3));
        const scalarList alpha(cells.column(4));

        // Of water, and of all
        std::map<long, std::pair<scalar, scalar>> volumes;
        forAll(x, i)
        {
            const scalar volume = pow3(size[i]);
            auto& sums = volumes[std::lround(1e6*x[i])];
            sums.first += alpha[i]*volume;
            sums.second += volume;
        }

        series s;
        for (const auto& v : volumes)
        {
            s.x.append(1e-6*v.first);
            s.y.append(height*v.second.first/v.second.second);
        }
        return s;
    };
}


struct wayToObserve
{
    //- Of its dictionary, beside "type"
    wordList keys;

    void (*observe)(observer& o);
};

//- All types, by their names
const HashTable<wayToObserve>& types()
{
    static const HashTable<wayToObserve> all
    ({
        {
            "level", {{"field", "end", "points", "interval"}, observeLevel}
        },
        {
            "probe",
            {
                {"field", "patch", "component", "scale", "offset", "interval"},
                observeProbe
            }
        },
        {"profile", {{"function", "height"}, observeProfile}},
        {
            "table",
            {
                {"function", "file", "xColumn", "column", "scale", "offset"},
                observeTable
            }
        }
    });
    return all;
}

} // End anonymous namespace


Foam::misfit::observer::observer(const channel& c)
:
    of(c)
{
    const wayToObserve& way = types()
    [
        keywords::choice
        (
            c.simulated, "type", "way to observe " + c.name, types().sortedToc()
        )
    ];
    wordList keys(way.keys);
    keys.append("type");
    keywords::check(c.simulated, keys);
    way.observe(*this);

    const scalar scale = c.simulated.getOrDefault<scalar>("scale", 1);
    const scalar offset = c.simulated.getOrDefault<scalar>("offset", 0);
    read = [=, written = read](const fileName& caseFolder)
    {
        series s(written(caseFolder));
        for (scalar& value : s.y)
        {
            value = scale*value + offset;
        }
        return s;
    };
}
