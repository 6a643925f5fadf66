// SPDX-License-Identifier: GPL-3.0-or-later
// Whether water and grains are all still there.

#include "massBalance.H"

#include "addToRunTimeSelectionTable.H"
#include "granularPhase.H"
#include "surfaceFields.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(massBalance, 0);
    addToRunTimeSelectionTable(functionObject, massBalance, dictionary);
}
}


Foam::functionObjects::massBalance::massBalance
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName),
    initialVolume_(0),
    initialGrains_(0),
    outflow_(0),
    enteredBefore_(0),
    leftBefore_(0),
    lastIndex_(-1),
    begun_(false)
{
    read(dict);

    if (writes())
    {
        writeColumns
        (
            file(),
            "Water: volume and net outflow since the start in m3, what is"
            " missing as a share of the initial volume. Grains: number, mass"
            " in kg, entered and left since the start, number missing",
            {
                "waterVolume", "outflow", "waterError",
                "nGrains", "grainMass", "entered", "left", "grainsMissing"
            }
        );
    }

    // On a running case this is before the first step
    if
    (
        !functionObject::postProcess
     && mesh_.foundObject<volScalarField>(alphaName_)
    )
    {
        begin();
    }
}


bool Foam::functionObjects::massBalance::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "alphaPhi"
        }
    );

    fluxName_ = dict.getOrDefault<word>("alphaPhi", "alphaPhi");

    return true;
}


bool Foam::functionObjects::massBalance::restoreStart()
{
    label entered = 0;
    label left = 0;

    const bool complete =
        restore("initialVolume", initialVolume_)
     && restore("initialGrains", initialGrains_)
     && restore("outflow", outflow_)
     && restore("entered", entered)
     && restore("left", left);

    enteredBefore_ += entered;
    leftBefore_ += left;

    return complete;
}


void Foam::functionObjects::massBalance::beginWater()
{
    initialVolume_ = gSum(waterVolume()());
    setProperty("initialVolume", initialVolume_);
}


void Foam::functionObjects::massBalance::begin()
{
    begun_ = true;

    // Grains are counted from here, whatever was counted before
    const FixedList<scalar, 4> count(grainCount());
    enteredBefore_ = -label(count[2]);
    leftBefore_ = -label(count[3]);

    if (restoreStart())
    {
        // As results were written LIGGGHTS took out what was beyond a side
        label written = label(count[0]);
        restore("grains", written);
        const label takenOut = written - label(count[0]);
        leftBefore_ += takenOut;
        if (takenOut != 0)
        {
            Info<< type() << " " << name() << ": " << takenOut << " grains were"
                << " beyond a side when this state was written and are not in"
                << " it; they count as left." << endl;
        }

        // Grains that were alone until now
        if (initialVolume_ == 0 && outflow_ == 0)
        {
            beginWater();
        }
        return;
    }

    beginWater();
    initialGrains_ = label(count[0]);

    setProperty("initialGrains", initialGrains_);
}


Foam::scalar Foam::functionObjects::massBalance::outflowOfStep() const
{
    if (!fluid_)
    {
        return 0;
    }

    const tmp<surfaceScalarField> flux(field<surfaceScalarField>(fluxName_));

    scalar out = 0;
    for (const fvsPatchScalarField& patch : flux().boundaryField())
    {
        if (!patch.coupled())
        {
            out += sum(patch);
        }
    }

    return returnReduce(out, sumOp<scalar>())*mesh_.time().deltaTValue();
}


Foam::FixedList<Foam::scalar, 4>
Foam::functionObjects::massBalance::grainCount() const
{
    FixedList<scalar, 4> result(scalar(0));

    const auto* running =
        mesh_.cfindObject<granularPhase>(granularPhase::typeName);

    if (running && !functionObject::postProcess)
    {
        result[0] = running->nBodies();
        result[1] = returnReduce(sum(running->mass()), sumOp<scalar>());
        result[2] = running->nEntered();
        result[3] = running->nLeft();
    }
    else if (functionObject::postProcess)
    {
        result[0] = grains().nBodies();
        result[1] = gSum(grains().mass);
    }

    result[2] += enteredBefore_;
    result[3] += leftBefore_;

    return result;
}


bool Foam::functionObjects::massBalance::sample()
{
    if (passOver({alphaName_, voidFractionName_}))
    {
        return false;
    }

    if (functionObject::postProcess)
    {
        // What flowed out between two written times is known from the run
        enteredBefore_ = 0;
        leftBefore_ = 0;

        if (restoreStart())
        {
            begun_ = true;
        }
        else if (!begun_)
        {
            begin();
            Info<< type() << " " << name() << ": the run had no function"
                << " object of this name, so what flowed out or left is taken"
                << " as zero." << endl;
        }

        return true;
    }

    if (!begun_)
    {
        begin();
    }

    const label index = mesh_.time().timeIndex();

    if (lastIndex_ >= 0 && index > lastIndex_ + 1)
    {
        FatalErrorInFunction
            << type() << " " << name() << " was not executed in "
            << index - lastIndex_ - 1 << " steps, so outflow is missing. It needs"
            << " each step: executeControl timeStep with executeInterval 1, as"
            << " without both." << nl
            << "    Remove executeControl and executeInterval from its"
            << " dictionary; writeControl and writeInterval set how often it"
            << " writes."
            << exit(FatalError);
    }

    lastIndex_ = index;
    outflow_ += outflowOfStep();

    const FixedList<scalar, 4> count(grainCount());
    setProperty("outflow", outflow_);
    setProperty("grains", label(count[0]));
    setProperty("entered", label(count[2]));
    setProperty("left", label(count[3]));

    return true;
}


void Foam::functionObjects::massBalance::report()
{
    const scalar volume = gSum(waterVolume()());
    const FixedList<scalar, 4> n(grainCount());

    const scalar error =
        (volume + outflow_ - initialVolume_)/max(initialVolume_, VSMALL);
    const scalar missing = initialGrains_ + n[2] - n[3] - n[0];

    setResult("waterError", error);
    setResult("grainsMissing", missing);

    Log << type() << " " << name() << ": water " << volume
        << " m3, missing " << -error << " of it; grains " << n[0]
        << ", missing " << missing << nl << endl;

    if (writes())
    {
        writeLine
        (
            file(),
            scalarList
            ({volume, outflow_, error, n[0], n[1], n[2], n[3], missing})
        );
    }
}
