// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the bed's erosion: columns, summary, profile, plan view,
// velocities.

#include "bedErosion.H"

#include "erosionPhases.H"

void Foam::functionObjects::bedErosion::writeHeaders()
{
    writeColumns
    (
        file(),
        "Erosion of the bed; lengths in m, velocities in m/s, volumes in m3",
        {
            "H", "depthX0", "rate", "L", "xEnd", "Lc", "LcRaw", "xFarthest",
            "Ue", "Ubouncing", "eroded", "deposited", "bedVolume", "xRaised", "Ubed"
        }
    );

    writeColumns
    (
        extraFile("layers"),
        "Layers of the bed in layerRange: thickness in m, mean velocity"
        " downslope in m/s, number of grains",
        {
            "bouncing", "Ubouncing", "nBouncing",
            "creeping", "Ucreeping", "nCreeping",
            "stationary", "Ustationary", "nStationary"
        }
    );

    writeColumns
    (
        extraFile("summary"),
        "So far: H, L and Lc in m; phases in s (-1: not reached); peak rate"
        " and mean velocities of the eroded material and of the whole bed during"
        " net erosion in m/s",
        {
            "H", "L", "Lc", "netStart", "netEnd", "peakRate", "peakTime", "Ue",
            "Ubed"
        }
    );
}


void Foam::functionObjects::bedErosion::writeSummary()
{
    const erosionPhases phases(depth_, rate_, onset_, attenuation_);
    const auto reached = [](const scalar t) { return t < GREAT/2 ? t : -1; };

    writeLine
    (
        extraFile("summary"),
        scalarList
        ({
            line_[0],
            line_[3],
            line_[5],
            reached(phases.netStart),
            reached(phases.netEnd),
            phases.peakRate,
            reached(phases.peakTime),
            UEroded_.mean(phases.netStart, phases.netEnd),
            UBed_.mean(phases.netStart, phases.netEnd)
        })
    );
}


void Foam::functionObjects::bedErosion::writeProfile
(
    const strips& depth
) const
{
    if (!writes())
    {
        return;
    }

    autoPtr<OFstream> file(presentFile("profile"));

    writeColumns
    (
        *file,
        "Along the flume: reference and present thickness of the bed, erosion"
        " depth, all in m at the bed's own packing",
        {"x", "reference", "thickness", "depth"},
        false
    );

    forAll(depth.values(), i)
    {
        const scalar before =
            reference_.volume[i]/(reference_.packing*width_*stripWidth_);
        const scalar h = depth.values()[i];

        writeRow(*file, scalarList({depth.centre(i), before, before - h, h}));
    }
}


void Foam::functionObjects::bedErosion::writePlanView
(
    const bedGrains& bed
) const
{
    const planGrid grid(box(), planWidth_);
    const scalarField volume(bed.overPlan(grid));
    const scalarField highest(bed.highest(grid, bouncingSpeed()));

    if (!writes())
    {
        return;
    }

    autoPtr<OFstream> file(presentFile("planView"));

    writeColumns
    (
        *file,
        "The bed from above: height of its surface (top of the highest grain"
        " that does not bounce; -1 without grain) and erosion depth from the"
        " change of volume; all in m",
        {"x", "y", "surface", "depth"},
        false
    );

    forAll(volume, c)
    {
        const scalar depth =
            (reference_.planVolume[c] - volume[c])
           /(reference_.packing*grid.area());

        const scalar surface =
            highest[c] > -GREAT/2 ? highest[c] + reference_.d/2 : -1;

        writeRow(*file, scalarList({grid.x(c), grid.y(c), surface, depth}));
    }
}


void Foam::functionObjects::bedErosion::writeVelocities
(
    const bedGrains& bed
) const
{
    strips volume(box().min().z(), box().max().z(), reference_.d);
    strips flux(volume);

    forAll(bed.d, i)
    {
        const scalar x = bed.centre[i].x();

        if (x >= layerRange_.first() && x <= layerRange_.second())
        {
            volume.add(bed.centre[i].z(), bed.volume[i]);
            flux.add(bed.centre[i].z(), bed.volume[i]*bed.U[i].x());
        }
    }

    volume.reduce();
    flux.reduce();

    if (!writes())
    {
        return;
    }

    autoPtr<OFstream> file(presentFile("velocityProfile"));

    writeColumns
    (
        *file,
        "Bed grains in layerRange by height: solid volume in m3 and mean"
        " velocity downslope in m/s",
        {"z", "volume", "U"},
        false
    );

    forAll(volume.values(), i)
    {
        const scalar v = volume.values()[i];
        if (v > 0)
        {
            writeRow
            (
                *file,
                scalarList({volume.centre(i), v, flux.values()[i]/v})
            );
        }
    }
}


void Foam::functionObjects::bedErosion::report()
{
    if (writes())
    {
        writeLine(file(), line_);
        writeLine(extraFile("layers"), layerLine_);
        writeSummary();
    }

    if (functionObject::postProcess || mesh_.time().writeTime())
    {
        const bedGrains grains(bed());

        writeProfile(erosionDepth(grains));
        writePlanView(grains);
        writeVelocities(grains);
    }
}
