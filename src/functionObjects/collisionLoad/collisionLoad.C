// SPDX-License-Identifier: GPL-3.0-or-later
// How hard the grains of a surge hit, and what energy its head brings.

#include "collisionLoad.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(collisionLoad, 0);
    addToRunTimeSelectionTable(functionObject, collisionLoad, dictionary);
}
}


Foam::functionObjects::collisionLoad::collisionLoad
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);

    force_ = keptSeries("force");
    number_ = keptSeries("number");

    if (mass_ <= 0)
    {
        kept("mass", mass_);
    }

    if (writes())
    {
        writeHeaders();
    }
}


void Foam::functionObjects::collisionLoad::writeHeaders()
{
    writeColumns
    (
        file(),
        "Contact forces of grains in the range: mean and greatest magnitude"
        " in N, number of grains",
        {"Fc", "FcMax", "n"}
    );

    writeColumns
    (
        extraFile("summary"),
        "So far: point load Fc in N (Eq 14), mass M in kg, thickness h in m,"
        " Fr, impact energy E in J (Eq 15; 0: not known)",
        {"Fc", "M", "h", "Fr", "E"}
    );
}


void Foam::functionObjects::collisionLoad::writeSummary()
{
    scalar h = 0;
    scalar Fr = 0;

    if
    (
        surgeFront_.size()
     && !(
            getObjectResult(surgeFront_, "h", h)
         && getObjectResult(surgeFront_, "Fr", Fr)
        )
    )
    {
        WarningInFunction
            << type() << " " << name() << ": no results of surgeFront "
            << surgeFront_ << ", so no impact energy. Give the name of a"
            << " surgeFront that stands before this in the functions." << endl;
    }

    const scalar E = mass_*mag(gravity())*h*(1 + sqr(Fr)/2);

    writeLine
    (
        extraFile("summary"),
        scalarList({pointLoad(), mass_, h, Fr, E})
    );
}


bool Foam::functionObjects::collisionLoad::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "types", "range", "window", "surgeFront", "mass"
        }
    );

    types_ = labelHashSet(dict.get<labelList>("types"));
    range_ =
        dict.lookupOrDefault("range", Tuple2<scalar, scalar>(1.1, 1.3));
    window_ =
        dict.lookupOrDefault("window", Tuple2<scalar, scalar>(0.5, 0.7));
    surgeFront_ = dict.lookupOrDefault<word>("surgeFront", "");
    mass_ = dict.lookupOrDefault<scalar>("mass", 0);

    if
    (
        range_.first() >= range_.second()
     || window_.first() >= window_.second()
    )
    {
        FatalIOErrorInFunction(dict)
            << "range " << range_ << " m and window " << window_
            << " s must go from a lower to a higher value."
            << exit(FatalIOError);
    }

    return true;
}


Foam::scalar Foam::functionObjects::collisionLoad::measuredMass() const
{
    const grainSnapshot& all = grains();
    scalar mass = 0;

    for (const label i : ofTypes(all, types_))
    {
        mass += all.mass[i];
    }

    return
        returnReduce(mass, sumOp<scalar>())
      + rhoWater()*gSum(waterVolume()());
}


Foam::scalar Foam::functionObjects::collisionLoad::pointLoad() const
{
    scalar force = 0;
    scalar number = 0;

    forAll(force_.times(), i)
    {
        const scalar t = force_.times()[i];

        if (t >= window_.first() - SMALL && t <= window_.second() + SMALL)
        {
            force += force_.values()[i];
            number += number_.values()[i];
        }
    }

    return number > 0 ? force/number : 0;
}


bool Foam::functionObjects::collisionLoad::execute()
{
    if (mass_ <= 0 && surgeFront_.size())
    {
        mass_ = measuredMass();
        setProperty("mass", mass_);
    }

    const grainSnapshot& all = grains();
    scalar sum = 0;
    scalar greatest = 0;
    label n = 0;

    for (const label i : ofTypes(all, types_))
    {
        const scalar x = frame_.x(all.position[i]);

        if (x >= range_.first() && x <= range_.second())
        {
            const scalar F = mag(all.contactForce[i]);
            sum += F;
            greatest = max(greatest, F);
            ++n;
        }
    }

    reduce(sum, sumOp<scalar>());
    reduce(greatest, maxOp<scalar>());
    reduce(n, sumOp<label>());

    force_.append(now(), sum);
    number_.append(now(), n);
    keep("force", force_);
    keep("number", number_);
    line_ = {sum/max(n, 1), greatest, scalar(n)};

    setResult("Fc", pointLoad());

    return true;
}


bool Foam::functionObjects::collisionLoad::write()
{
    if (writes())
    {
        writeLine(file(), line_);
        writeSummary();
    }

    return true;
}
