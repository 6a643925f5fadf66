// SPDX-License-Identifier: GPL-3.0-or-later
// A box of grains that fall, slide and roll to rest, computed by LIGGGHTS.

#include "settlingBox.H"
#include "grainsData.H"

#include <mpi.h>
#include <liggghts/library.h>

#include <sstream>

namespace Foam
{
namespace
{

//- Looks at the grains this often [s]
constexpr scalar lookEvery = 0.02;

//- Gives up after this time [s]
constexpr scalar patience = 10;


//- Its arguments one behind the other, numbers to the last digit
template<class... Words>
std::string joined(const Words&... words)
{
    std::ostringstream os;
    os.precision(17);
    (os << ... << words);
    return os.str();
}

} // End anonymous namespace
} // End namespace Foam


Foam::settlingBox::settlingBox
(
    const packingBox& box,
    const packedGrains& grains,
    const grainContactModel& contact,
    const scalar step,
    const fileName& folder
)
:
    box_(box),
    grains_(grains),
    gravity_(Zero),
    step_(step),
    liggghts_(folder/"log.settling")
{
    readGrains(folder);
    contact.apply(liggghts_);
    addWalls();

    liggghts_.command(joined("timestep ", step_));
    // LIGGGHTS goes through its fixes in the order in which they came: gravity
    // must be there before grains are held against it
    liggghts_.command("fix gravity all gravity 0 vector 0 0 -1");
    liggghts_.command("fix integrate all nve/sphere");
}


void Foam::settlingBox::setGravity(const vector& gravity)
{
    gravity_ = gravity;
    liggghts_.command
    (
        joined
        (
            "fix gravity all gravity ", mag(gravity), " vector ",
            gravity.x(), ' ', gravity.y(), ' ', gravity.z()
        )
    );
}


void Foam::settlingBox::readGrains(const fileName& folder)
{
    // In here all grains are of one material
    packedGrains atoms(grains_);
    atoms.material = 1;
    const fileName file(folder/"settling.data");
    writeGrainsData(file, atoms, box_.bounds(), "Grains before they settle");

    std::string boundary("boundary");
    for (direction d = 0; d < 3; ++d)
    {
        boundary += box_.periodic(d) ? " p" : " f";
    }

    liggghts_.command("units si");
    liggghts_.command("atom_style granular");
    liggghts_.command(boundary);
    liggghts_.command("newton off");
    liggghts_.command("communicate single vel yes");
    liggghts_.command("read_data " + file);
    liggghts_.command(joined("neighbor ", 0.2*min(grains_.diameter), " bin"));
    liggghts_.command("neigh_modify delay 0");
}


void Foam::settlingBox::addWalls()
{
    const auto addPlane = [&](const char axis, const char* side, scalar at)
    {
        liggghts_.command
        (
            joined
            (
                "fix wall", axis, side, " all wall/gran ",
                grainContactModel::model,
                " primitive type 1 ", axis, "plane ", at
            )
        );
    };

    for (direction d = 0; d < 3; ++d)
    {
        if (!box_.periodic(d))
        {
            addPlane(char('x' + d), "Min", box_.bounds().min()[d]);
            addPlane(char('x' + d), "Max", box_.bounds().max()[d]);
        }
    }
}


void Foam::settlingBox::freeze(const scalar xMin, const scalar xMax)
{
    liggghts_.command
    (
        joined
        (
            "region held block ", xMin, ' ', xMax,
            " INF INF INF INF units box"
        )
    );
    liggghts_.command("group held region held");
    liggghts_.command("fix held held freeze");
}


Foam::scalar Foam::settlingBox::standStill() const
{
    return 1e-3*std::sqrt(2*mag(gravity_)*min(grains_.diameter));
}


Foam::scalar Foam::settlingBox::update()
{
    void* lmp = &*liggghts_;
    const auto x = static_cast<double**>(lammps_extract_atom(lmp, "x"));
    const auto id = static_cast<int*>(lammps_extract_atom(lmp, "id"));
    const label n = *static_cast<int*>(lammps_extract_global(lmp, "nlocal"));

    if (n != grains_.size())
    {
        FatalErrorInFunction
            << grains_.size() - n << " of " << grains_.size()
            << " grains left the box " << box_.bounds() << " while settling."
            << nl << "    Give a smaller timeStep in system/packingDict"
            << exit(FatalError);
    }

    scalar way = 0;
    for (label i = 0; i < n; ++i)
    {
        point& p = grains_.position[id[i] - 1];
        const point last(p);
        p = point(x[i][0], x[i][1], x[i][2]);
        box_.wrap(p);
        way += mag(box_.nearest(p - last));
    }
    return way/n;
}


const Foam::packedGrains& Foam::settlingBox::settle(const scalar atLeast)
{
    const label steps = max(label(lookEvery/step_), label(1));
    scalar time = 0;
    scalar speed = grains_.size() ? GREAT : 0;

    while (speed > standStill() || time < atLeast)
    {
        if (time > patience)
        {
            FatalErrorInFunction
                << "The grains still move at " << speed << " m/s after "
                << time << " s of settling, more than " << standStill()
                << " m/s. With this friction the bed does not stand on this"
                << " slope: raise friction or rollingFriction in"
                << " system/packingDict, or tilt gravity less in constant/g"
                << exit(FatalError);
        }

        liggghts_.command(joined("run ", steps));
        time += steps*step_;
        speed = update()/(steps*step_);
    }
    return grains_;
}
