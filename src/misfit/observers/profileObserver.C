// SPDX-License-Identifier: GPL-3.0-or-later
// Observes the surface of the water over a distance, at a time.

#include "observer.H"
#include "addToRunTimeSelectionTable.H"
#include "keywords.H"
#include "writtenTable.H"

#include <map>

namespace Foam::misfit
{

//- From the table of cells that a sideView of the case writes at the time of the
//  channel: the depth is the share of water in a column of cells times the
//  height of the mesh. For meshes of upright columns.
class profileObserver
:
    public observer
{
    //- Name of the sideView
    word function_;

    //- Height of the mesh [m]
    scalar height_;


public:

    TypeName("profile");

    explicit profileObserver(const channel& c);

    series read(const fileName& caseFolder) const override;
};

defineTypeNameAndDebug(profileObserver, 0);
addToRunTimeSelectionTable(observer, profileObserver, channel);

} // End namespace Foam::misfit


Foam::misfit::profileObserver::profileObserver(const channel& c)
:
    observer(c),
    function_(c.simulated.get<word>("function")),
    height_(c.simulated.get<scalar>("height"))
{
    keywords::check(c.simulated, {"type", "function", "height"});
    if (height_ <= 0)
    {
        FatalIOErrorInFunction(c.simulated)
            << "The channel " << c.name << " has the height " << height_
            << " m. Give that of the mesh, above zero" << exit(FatalIOError);
    }
    if (c.overTime())
    {
        FatalIOErrorInFunction(c.simulated)
            << "The channel " << c.name << " is a profile, and runs over a"
            << " distance: give the time of it,  at <seconds>;"
            << exit(FatalIOError);
    }
}


Foam::misfit::series
Foam::misfit::profileObserver::read(const fileName& caseFolder) const
{
    const writtenTable cells
    (
        nearestTimeFolder(caseFolder, function_, of().at)/"cells.dat"
    );

    // Columns of a sideView: x y z size alpha speed
    std::map<long, std::pair<scalar, scalar>> volumes;
    forAll(cells.rows(), i)
    {
        const scalar volume = pow3(cells.value(i, 3));
        auto& sums = volumes[std::lround(1e6*cells.value(i, 0))];
        sums.first += cells.value(i, 4)*volume;
        sums.second += volume;
    }

    series s;
    for (const auto& v : volumes)
    {
        s.x.append(1e-6*v.first);
        s.y.append(height_*v.second.first/v.second.second);
    }
    return s;
}
