// SPDX-License-Identifier: GPL-3.0-or-later
// Observes the level of the water above the place of the channel.

#include "observer.H"
#include "probeObserver.H"
#include "addToRunTimeSelectionTable.H"
#include "keywords.H"
#include "writtenTable.H"

namespace Foam::misfit
{

//- Integral of the share of water along a line from the place of the channel,
//  by points that lie evenly on it [m]. Drops above the surface count with
//  what they hold.
class levelObserver
:
    public observer
{
    word field_;

    //- From the place to the end of the line [m]
    vector span_;

    //- Number of points
    label n_;

    label interval_;


public:

    TypeName("level");

    explicit levelObserver(const channel& c);

    void addTo(dictionary& functions) const override;

    series read(const fileName& caseFolder) const override;

    //- The points along the line
    pointField places() const override;
};

defineTypeNameAndDebug(levelObserver, 0);
addToRunTimeSelectionTable(observer, levelObserver, channel);

} // End namespace Foam::misfit


Foam::misfit::levelObserver::levelObserver(const channel& c)
:
    observer(c),
    field_(c.simulated.getOrDefault<word>("field", "alpha.water")),
    span_(c.simulated.get<point>("end") - c.place()),
    n_(c.simulated.getOrDefault<label>("points", 100)),
    interval_(c.simulated.getOrDefault<label>("interval", 1))
{
    keywords::check
    (
        c.simulated, {"type", "field", "end", "points", "interval"}
    );
    requirePlace(c);
    if (n_ < 2 || mag(span_) < SMALL)
    {
        FatalIOErrorInFunction(c.simulated)
            << "The level " << c.name << " needs a line: two points or more,"
            << " and an end that is not its place" << exit(FatalIOError);
    }
}


Foam::pointField Foam::misfit::levelObserver::places() const
{
    pointField points(n_);
    forAll(points, i)
    {
        points[i] = of().place() + (i + 0.5)/n_*span_;
    }
    return points;
}


void Foam::misfit::levelObserver::addTo(dictionary& functions) const
{
    functions.add
    (
        of().name,
        probes(field_, places(), wordList(), interval_)
    );
}


Foam::misfit::series
Foam::misfit::levelObserver::read(const fileName& caseFolder) const
{
    const writtenTable table(caseFolder, of().name, field_);
    if (table.notFound().size())
    {
        FatalErrorInFunction
            << "The line of the level " << of().name << " from "
            << of().place() << " by " << span_
            << " leaves the mesh. Mend place or end" << exit(FatalError);
    }

    series s;
    forAll(table.rows(), i)
    {
        scalar sum = 0;
        for (label p = 0; p < n_; ++p)
        {
            sum += table.value(i, 1 + p);
        }
        s.x.append(table.value(i, 0));
        s.y.append(sum/n_*mag(span_));
    }
    return s;
}
