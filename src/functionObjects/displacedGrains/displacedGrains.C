// SPDX-License-Identifier: GPL-3.0-or-later
// What has moved away from where it was: volume, velocity, depth along the bed.

#include "displacedGrains.H"

#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(displacedGrains, 0);
    addToRunTimeSelectionTable(functionObject, displacedGrains, dictionary);
}
}


Foam::functionObjects::displacedGrains::displacedGrains
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName),
    origins_(mesh_)
{
    read(dict);

    if (writes())
    {
        writeHeaders();
    }
}


void Foam::functionObjects::displacedGrains::writeHeaders()
{
    wordList names
    ({
        "n", "volume", "U", "nMoving", "volumeMoving", "UMoving"
    });
    forAll(sections_, i)
    {
        names.append(word("depth:" + Foam::name(i), false));
    }

    writeColumns
    (
        file(),
        "Grains displaced by more than the threshold: number, solid volume in m3,"
        " mean velocity downslope by volume in m/s; of these, those that move; depth"
        " in m that they left at the sections",
        names
    );
}


bool Foam::functionObjects::displacedGrains::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "types", "bedTypes", "threshold", "speed", "sections",
            "sectionWidth", "packing", "width", "discs"
        }
    );

    types_ = labelHashSet(dict.getOrDefault("types", labelList()));
    bedTypes_ = labelHashSet(dict.getOrDefault("bedTypes", labelList()));
    threshold_ = dict.getOrDefault<scalar>("threshold", 0);
    speed_ = dict.getOrDefault<scalar>("speed", 0);
    sections_ = dict.getOrDefault("sections", scalarList());
    sectionWidth_ = dict.getOrDefault<scalar>("sectionWidth", 0.02);
    packing_ = dict.getOrDefault<scalar>("packing", 0.6);
    width_ = dict.getOrDefault<scalar>("width", box().span().y());
    discs_ = dict.getOrDefault("discs", false);

    if (sectionWidth_ <= 0 || packing_ <= 0 || packing_ > 1 || width_ <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "sectionWidth is " << sectionWidth_ << " m, width " << width_
            << " m, packing " << packing_ << nl
            << "    Give lengths above zero and a packing up to 1."
            << exit(FatalIOError);
    }

    return true;
}


Foam::fileName Foam::functionObjects::displacedGrains::originsFile() const
{
    return baseFileDir()/name()/"origins";
}


Foam::scalar Foam::functionObjects::displacedGrains::volume
(
    const scalar d
) const
{
    using constant::mathematical::pi;
    return discs_ ? pi*sqr(d)/4*width_ : pi*pow3(d)/6;
}


Foam::scalar Foam::functionObjects::displacedGrains::meanDiameter
(
    const labelList& chosen
) const
{
    scalar sum = 0;
    for (const label i : chosen)
    {
        sum += bodies().d[i];
    }
    const label n = returnReduce(chosen.size(), sumOp<label>());
    return returnReduce(sum, sumOp<scalar>())/max(n, 1);
}


void Foam::functionObjects::displacedGrains::writeOrigins()
{
    // True on the first rank alone, and all bring theirs
    const bool toFile = returnReduce(writeToFile(), orOp<bool>());

    if (origins_.hasNew() && toFile)
    {
        origins_.write(originsFile());
    }
}


bool Foam::functionObjects::displacedGrains::isContinuation()
{
    // Later on there may be the origins of another run of this case, which began with
    // grains before this one; postProcess begins with times that have none
    if (continuationChecked_ && !functionObject::postProcess)
    {
        return false;
    }
    continuationChecked_ = true;

    // Origins of now or later are those of an earlier run of this case
    if (origins_.read(originsFile()) && origins_.time < now() - SMALL)
    {
        return true;
    }

    origins_.clear();
    return false;
}


void Foam::functionObjects::displacedGrains::begin(const labelList& chosen)
{
    origins_.time = now();
    origins_.d = meanDiameter(chosen);
    origins_.of(bodies(), chosen);
    writeOrigins();
    Info<< type() << " " << name() << ": displacements from time " << now()
        << " s; mean diameter " << origins_.d << " m" << endl;
}


void Foam::functionObjects::displacedGrains::addTo
(
    scalarField& left,
    const grainOrigins::record& r
) const
{
    if (!bedTypes_.empty() && !bedTypes_.found(r.type))
    {
        return;
    }

    forAll(sections_, i)
    {
        if (mag(frame_.x(r.origin) - sections_[i]) <= sectionWidth_/2)
        {
            left[i] += volume(r.d);
        }
    }
}


bool Foam::functionObjects::displacedGrains::sample()
{
    const labelList chosen(ofTypes(bodies(), types_));

    // Also where all have left that the run before began with
    const bool begun = origins_.time < GREAT || isContinuation();
    if (!begun && returnReduce(chosen.size(), sumOp<label>()))
    {
        begin(chosen);
    }

    const scalar far = threshold_ > 0 ? threshold_ : 2*origins_.d;
    const scalar fast =
        speed_ > 0 ? speed_ : 0.05*sqrt(mag(gravity())*cosSlope()*origins_.d);

    // n, volume, volume times velocity: of those displaced, of those that move
    scalarField sums(6, Zero);
    scalarField left(sections_.size(), Zero);

    for (const grainOrigins::record& r : origins_.of(bodies(), chosen))
    {
        if (mag(r.displacement) <= far)
        {
            continue;
        }

        const scalar V = volume(r.d);
        const scalar U = r.U & frame_.downslope();
        for (const label k : mag(r.U) > fast ? labelList{0, 3} : labelList{0})
        {
            sums[k] += 1;
            sums[k + 1] += V;
            sums[k + 2] += V*U;
        }
        addTo(left, r);
    }

    for (const grainOrigins::record& r : origins_.ofAbsent())
    {
        addTo(left, r);
    }

    // Before the time from which a run may go on
    if (mesh_.time().writeTime())
    {
        writeOrigins();
    }

    reduce(sums, sumOp<scalarField>());
    reduce(left, sumOp<scalarField>());
    sums[2] /= max(sums[1], VSMALL);
    sums[5] /= max(sums[4], VSMALL);

    line_ = sums;
    line_.append(left/(packing_*width_*sectionWidth_));
    setResult("UMoving", sums[5]);

    return true;
}


void Foam::functionObjects::displacedGrains::report()
{
    if (writes())
    {
        writeLine(file(), line_);
    }
}


bool Foam::functionObjects::displacedGrains::end()
{
    // A run that is stopped early writes a time that was not due
    writeOrigins();
    return true;
}
