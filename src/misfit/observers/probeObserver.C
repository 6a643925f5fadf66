// SPDX-License-Identifier: GPL-3.0-or-later
// Observes a field at the place of the channel.

#include "probeObserver.H"
#include "addToRunTimeSelectionTable.H"
#include "keywords.H"
#include "fileName.H"
#include "writtenTable.H"

namespace Foam::misfit
{
    defineTypeNameAndDebug(probeObserver, 0);
    addToRunTimeSelectionTable(observer, probeObserver, channel);
}


Foam::dictionary Foam::misfit::probes
(
    const word& field,
    const pointField& points,
    const wordList& patches,
    const label interval
)
{
    dictionary dict;
    dict.add("type", word(patches.empty() ? "probes" : "patchProbes"));
    dict.add("libs", List<fileName>(1, fileName("libsampling.so")));
    dict.add("fields", wordList(1, field));
    dict.add("probeLocations", points);
    if (patches.size())
    {
        dict.add("patches", patches);
    }
    dict.add("writeControl", word("timeStep"));
    dict.add("writeInterval", interval);
    return dict;
}


void Foam::misfit::requirePlace(const channel& c)
{
    if (!c.samples.hasPlace)
    {
        FatalIOErrorInFunction(c.simulated)
            << "The channel " << c.name << " is observed at a point, but has"
            << " no place: give  place (x y z);  in metres"
            << exit(FatalIOError);
    }
}


Foam::misfit::probeObserver::probeObserver(const channel& c)
:
    observer(c),
    field_(c.simulated.get<word>("field")),
    component_(-1),
    scale_(c.simulated.getOrDefault<scalar>("scale", 1)),
    offset_(c.simulated.getOrDefault<scalar>("offset", 0)),
    interval_(c.simulated.getOrDefault<label>("interval", 1))
{
    const dictionary& dict = c.simulated;
    keywords::check
    (
        dict,
        {"type", "field", "patch", "component", "scale", "offset", "interval"}
    );
    requirePlace(c);

    if (dict.found("patch"))
    {
        patches_ = wordList(1, dict.get<word>("patch"));
    }
    if (dict.found("component"))
    {
        const word name
        (
            keywords::choice
            (
                dict, "component", "component", wordList({"x", "y", "z"})
            )
        );
        component_ = name[0] - 'x';
    }
}


void Foam::misfit::probeObserver::addTo(dictionary& functions) const
{
    functions.add
    (
        of().name,
        probes(field_, places(), patches_, interval_)
    );
}


Foam::misfit::series
Foam::misfit::probeObserver::read(const fileName& caseFolder) const
{
    const writtenTable table(caseFolder, of().name, field_);
    if (table.notFound().size())
    {
        FatalErrorInFunction
            << "The channel " << of().name << " is at " << of().place()
            << ", which is outside the mesh. Mend its place, or name the wall"
            << " that it is on:  patch <name>;" << exit(FatalError);
    }

    if (component_ < 0 && table.rows().size() && table.rows()[0].size() > 2)
    {
        FatalErrorInFunction
            << "The channel " << of().name << " observes the field " << field_
            << ", which has directions: name one,  component x;  (or y, z)"
            << exit(FatalError);
    }

    series s;
    forAll(table.rows(), i)
    {
        s.x.append(table.value(i, 0));
        s.y.append(scale_*table.value(i, 1 + max(component_, 0)) + offset_);
    }
    return s;
}
