// SPDX-License-Identifier: GPL-3.0-or-later
// The grains of the bed at one moment, and the bed before the flow came.

#include "bedState.H"

#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "dictionary.H"
#include "foamCompatibility.H"

Foam::bedGrains::bedGrains
(
    const flumeFrame& frame,
    const grainSnapshot& grains,
    const labelUList& chosen
)
:
    centre(chosen.size()),
    U(chosen.size()),
    d(chosen.size()),
    mass(chosen.size()),
    volume(chosen.size()),
    partOfBody(chosen.size()),
    bodyDiameter(chosen.size())
{
    forAll(chosen, i)
    {
        const vector& u = grains.U[chosen[i]];

        centre[i] = frame.local(grains.position[chosen[i]]);
        U[i].x() = u & frame.downslope();
        U[i].y() = u & frame.across();
        U[i].z() = u & frame.normal();
        d[i] = grains.d[chosen[i]];
        mass[i] = grains.mass[chosen[i]];
        volume[i] = grains.volume(chosen[i]);
        partOfBody[i] = grains.partOfBody(chosen[i]);
        bodyDiameter[i] = grains.bodyDiameter(chosen[i]);
    }
}


Foam::scalar Foam::bedGrains::meanDiameter() const
{
    const scalar d3 = gSum((partOfBody*pow3(bodyDiameter))());

    return d3 > 0 ? gSum((partOfBody*pow4(bodyDiameter))())/d3 : 0;
}


Foam::scalar Foam::bedGrains::meanVelocity() const
{
    const scalar m = gSum(mass);
    return m > 0 ? gSum((mass*U.component(vector::X))())/m : 0;
}


Foam::scalar Foam::bedGrains::farthest() const
{
    scalar x = -GREAT;
    for (const vector& c : centre)
    {
        x = max(x, c.x());
    }

    return returnReduce(x, maxOp<scalar>());
}


Foam::strips Foam::bedGrains::alongFlume
(
    const boundBox& box,
    const scalar width
) const
{
    strips along(box.min().x(), box.max().x(), width);

    forAll(centre, i)
    {
        along.addSphere(centre[i].x(), d[i]/2, volume[i]);
    }

    along.reduce();
    return along;
}


Foam::scalarField Foam::bedGrains::overPlan(const planGrid& grid) const
{
    scalarField result(grid.size(), Zero);

    forAll(centre, i)
    {
        result[grid.find(centre[i].x(), centre[i].y())] += volume[i];
    }

    reduce(result, sumOp<scalarField>());
    return result;
}


Foam::scalarField Foam::bedGrains::highest
(
    const planGrid& grid,
    const scalar maxSpeed
) const
{
    scalarField result(grid.size(), -GREAT);

    forAll(centre, i)
    {
        if (mag(U[i]) <= maxSpeed)
        {
            scalar& top = result[grid.find(centre[i].x(), centre[i].y())];
            top = max(top, centre[i].z());
        }
    }

    Pstream::listCombineGather(result, maxEqOp<scalar>());
    compatibility::broadcast(result);
    return result;
}


Foam::scalar Foam::corePacking
(
    const bedGrains& bed,
    const boundBox& box,
    const strips& along,
    const scalar flumeWidth
)
{
    const scalar d = bed.meanDiameter();
    const scalar enough = max(along.values())/2;
    strips height(box.min().z(), box.max().z(), d/10);

    forAll(bed.d, i)
    {
        const label strip = along.find(bed.centre[i].x());

        if (strip >= 0 && along.values()[strip] >= enough)
        {
            height.addSphere(bed.centre[i].z(), bed.d[i]/2, bed.volume[i]);
        }
    }
    height.reduce();

    label nStrips = 0;
    for (const scalar v : along.values())
    {
        nStrips += (v >= enough);
    }

    // Grains lie in layers near the base. Weights that rise over a diameter
    // from either end do not see where in a layer they begin
    const scalar low = height.quantile(0.01);
    const scalar high = height.quantile(0.99);
    scalar solid = 0;
    scalar thickness = 0;

    forAll(height.values(), i)
    {
        const scalar inside =
            min(height.centre(i) - low, high - height.centre(i));
        const scalar weight = max(min(inside/d, scalar(1)), scalar(0));

        solid += weight*height.values()[i];
        thickness += weight*height.width();
    }

    return
        solid/max(thickness, VSMALL)/(flumeWidth*nStrips*along.width());
}


void Foam::bedReference::take
(
    const scalar now,
    const bedGrains& bed,
    const boundBox& box,
    const scalar stripWidth,
    const scalar flumeWidth,
    const planGrid& grid,
    const scalar givenPacking
)
{
    const strips along(bed.alongFlume(box, stripWidth));

    time = now;
    d = bed.meanDiameter();
    packing =
        givenPacking > 0
      ? givenPacking
      : corePacking(bed, box, along, flumeWidth);
    end = bed.farthest();
    volume = along.values();
    highest = bed.highest(grid, GREAT);
    planVolume = bed.overPlan(grid);
}


bool Foam::bedReference::read(const fileName& file)
{
    bool exists = Pstream::master() && isFile(file);
    compatibility::broadcast(exists);

    if (!exists)
    {
        return false;
    }

    if (Pstream::master())
    {
        IFstream is(file);
        const dictionary dict(is);

        dict.readEntry("time", time);
        dict.readEntry("diameter", d);
        dict.readEntry("packing", packing);
        dict.readEntry("end", end);
        dict.readEntry("volume", volume);
        dict.readEntry("highest", highest);
        dict.readEntry("planVolume", planVolume);
    }

    compatibility::broadcast(time);
    compatibility::broadcast(d);
    compatibility::broadcast(packing);
    compatibility::broadcast(end);
    compatibility::broadcast(volume);
    compatibility::broadcast(highest);
    compatibility::broadcast(planVolume);

    return true;
}


void Foam::bedReference::write(const fileName& file) const
{
    mkDir(file.path());

    OFstream os(file);
    os.precision(16);

    os  << "// The bed before the flow came, for bedErosion" << nl;
    os.writeEntry("time", time);
    os.writeEntry("diameter", d);
    os.writeEntry("packing", packing);
    os.writeEntry("end", end);
    os.writeEntry("volume", volume);
    os.writeEntry("highest", highest);
    os.writeEntry("planVolume", planVolume);
    os.flush();

    if (!os.stdStream().good())
    {
        FatalErrorInFunction
            << "Cannot write " << file << ": is the disk full?"
            << exit(FatalError);
    }
}
