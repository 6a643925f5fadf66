// SPDX-License-Identifier: GPL-3.0-or-later
// What the function objects of interDEMFoam share.

#include "flumeFunctionObject.H"

#include "gravityMeshObject.H"
#include "hasFluid.H"
#include "keywords.H"
#include "snapshotCache.H"
#include "strips.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(flumeFunctionObject, 0);
}
}


namespace
{

//- Keys of OpenFOAM's function objects, and those that all of ours have
const Foam::wordList commonKeys
({
    "type", "libs", "functionObjectLibs", "enabled", "log", "errors",
    "region", "subRegion", "field", "fields",
    "timeStart", "timeEnd", "triggerStart", "triggerEnd", "controlMode",
    "deltaTCoeff", "nStepsToStartTimeChange",
    "executeControl", "executeInterval", "executeFrequency",
    "writeControl", "writeInterval", "writeFrequency",
    "outputControl", "outputInterval", "outputFrequency",
    "writePrecision", "writeToFile", "useUserTime",
    "origin", "downslope", "normal",
    "alpha", "voidFraction", "rhoWater"
});

} // End anonymous namespace


Foam::functionObjects::flumeFunctionObject::flumeFunctionObject
(
    const word& name,
    const Time& runTime,
    const dictionary& dict,
    const word& fileName
)
:
    fvMeshFunctionObject(name, runTime, dict),
    compatibility::writeFile(mesh_, name, fileName, dict),
    series_(name, runTime, !functionObject::postProcess),
    sampledAt_(-GREAT),
    sampled_(false),
    rhoWater_(0),
    fluid_(hasFluid(mesh_))
{}


bool Foam::functionObjects::flumeFunctionObject::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    compatibility::writeFile::read(dict);

    frame_ = flumeFrame(dict);
    alphaName_ = dict.getOrDefault<word>("alpha", "alpha.water");
    voidFractionName_ =
        dict.getOrDefault<word>("voidFraction", "voidFraction");
    rhoWater_ = dict.getOrDefault<scalar>("rhoWater", densityOfWater());

    // Read and reduced by all ranks at once: what is sampled may lie on one alone
    if
    (
        IOobject("g", mesh_.time().constant(), mesh_.time())
       .typeHeaderOk<uniformDimensionedVectorField>(true)
    )
    {
        gravity();
    }
    box_ = frame_.bounds(mesh_.points());

    return true;
}


void Foam::functionObjects::flumeFunctionObject::checkKeys
(
    const dictionary& dict,
    const wordList& keys
) const
{
    DynamicList<word> valid(keys);
    valid.append(commonKeys);
    keywords::check(dict, valid);
}


bool Foam::functionObjects::flumeFunctionObject::hasFluid(const fvMesh& mesh)
{
    const IOdictionary properties
    (
        IOobject
        (
            "granularProperties",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    return Foam::hasFluid(properties);
}


const Foam::grainSnapshot&
Foam::functionObjects::flumeFunctionObject::grains() const
{
    return snapshotCache::get(mesh_);
}


const Foam::grainSnapshot&
Foam::functionObjects::flumeFunctionObject::bodies() const
{
    return snapshotCache::bodies(mesh_);
}


void Foam::functionObjects::flumeFunctionObject::warnOfAbsent
(
    const grainSnapshot& grains,
    const labelHashSet& types
) const
{
    labelHashSet unknown(types);
    unknown -= knownTypes_;
    const labelList unknownTypes(unknown.sortedToc());

    if (unknownTypes.empty() || !returnReduce(grains.size(), sumOp<label>()))
    {
        return;
    }

    string absent;
    for (const label type : unknownTypes)
    {
        if (!returnReduce(grains.type.found(type), orOp<bool>()))
        {
            absent += " " + Foam::name(type);
        }
    }
    knownTypes_.insert(unknownTypes);

    if (absent.size())
    {
        WarningInFunction
            << type() << " " << name() << ": no grain has a type of" << absent.c_str()
            << "; those that are there have " << gMin(grains.type) << " to "
            << gMax(grains.type) << nl
            << "    It has left, is yet to come, or types is wrong; until a grain has it,"
            << " there is nothing to see of it." << endl;
    }
}


Foam::labelList Foam::functionObjects::flumeFunctionObject::ofTypes
(
    const grainSnapshot& grains,
    const labelHashSet& types
) const
{
    warnOfAbsent(grains, types);

    DynamicList<label> chosen(grains.size());
    forAll(grains.type, i)
    {
        if (types.empty() || types.found(grains.type[i]))
        {
            chosen.append(i);
        }
    }

    return chosen;
}


Foam::scalar Foam::functionObjects::flumeFunctionObject::extent
(
    const labelList& chosen,
    const scalar x1,
    const scalar x2
) const
{
    const scalar fine = 0.001;
    const scalar margin = 0.05;

    const grainSnapshot& all = grains();
    strips height(box().min().z(), box().max().z(), fine);

    for (const label i : chosen)
    {
        const scalar x = frame_.x(all.position[i]);

        if (x >= x1 && x <= x2)
        {
            height.addSphere
            (
                frame_.z(all.position[i]),
                all.d[i]/2,
                all.volume(i)
            );
        }
    }

    height.reduce();

    return
        (height.quantile(1 - margin) - height.quantile(margin))
       /(1 - 2*margin);
}


bool Foam::functionObjects::flumeFunctionObject::passOver
(
    const wordList& fields
) const
{
    if (!functionObject::postProcess || !fluid_)
    {
        return false;
    }

    for (const word& name : fields)
    {
        IOobject io
        (
            name,
            mesh_.time().timeName(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );

        // Of any class
        const bool there =
            mesh_.foundObject<regIOobject>(name)
         || io.typeHeaderOk<volScalarField>(false);

        if (returnReduce(name != "none" && !there, orOp<bool>()))
        {
            Info<< type() << " " << this->name() << ": time "
                << mesh_.time().timeName() << " is passed over, it has no "
                << name << endl;
            return true;
        }
    }

    return false;
}


Foam::tmp<Foam::volScalarField>
Foam::functionObjects::flumeFunctionObject::voidFraction() const
{
    if (voidFractionName_ == "none" || !fluid_)
    {
        return volScalarField::New
        (
            "voidFraction.none",
            mesh_,
            dimensionedScalar("one", dimless, 1)
        );
    }

    return field<volScalarField>(voidFractionName_);
}


Foam::tmp<Foam::volScalarField>
Foam::functionObjects::flumeFunctionObject::fluidField(const word& name) const
{
    if (!fluid_)
    {
        return volScalarField::New
        (
            name + ".none", mesh_, dimensionedScalar(dimless, Zero)
        );
    }

    return field<volScalarField>(name);
}


Foam::tmp<Foam::scalarField>
Foam::functionObjects::flumeFunctionObject::waterVolume() const
{
    if (!fluid_)
    {
        return tmp<scalarField>::New(mesh_.nCells(), Zero);
    }

    const tmp<volScalarField> alpha(field<volScalarField>(alphaName_));
    const tmp<volScalarField> epsilon(voidFraction());

    return epsilon().primitiveField()*alpha().primitiveField()*mesh_.V();
}


const Foam::vector&
Foam::functionObjects::flumeFunctionObject::gravity() const
{
    return meshObjects::gravity::New(mesh_.time()).value();
}


Foam::scalar Foam::functionObjects::flumeFunctionObject::cosSlope() const
{
    const vector& g = gravity();

    return mag(g & frame_.normal())/max(mag(g), SMALL);
}


Foam::scalar Foam::functionObjects::flumeFunctionObject::densityOfWater() const
{
    const IOdictionary properties
    (
        IOobject
        (
            "transportProperties",
            mesh_.time().constant(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    const word phase(IOobject::group(alphaName_));
    const dictionary& water = properties.subOrEmptyDict(phase);

    return
        fluid_ && water.found("rho")
      ? dimensionedScalar("rho", dimDensity, water).value() : 0;
}


Foam::scalar Foam::functionObjects::flumeFunctionObject::rhoWater() const
{
    if (rhoWater_ <= 0 && fluid_)
    {
        FatalErrorInFunction
            << "No density of water for the function object " << name() << nl
            << "    Give rhoWater in kg/m3, or rho in the entry "
            << IOobject::group(alphaName_) << " of constant/transportProperties"
            << exit(FatalError);
    }

    return rhoWater_;
}


Foam::OFstream&
Foam::functionObjects::flumeFunctionObject::extraFile(const word& name)
{
    if (!files_.found(name))
    {
        files_.set(name, newFileAtStartTime(name).release());
    }

    return *files_[name];
}


Foam::autoPtr<Foam::OFstream>
Foam::functionObjects::flumeFunctionObject::presentFile(const word& name) const
{
    return newFileAtTime(name, now());
}


void Foam::functionObjects::flumeFunctionObject::writeColumns
(
    Ostream& os,
    const string& comment,
    const wordList& columns,
    const bool withTime
) const
{
    writeHeader(os, comment);
    writeCommented(os, withTime ? "Time" : columns.first());

    forAll(columns, i)
    {
        if (withTime || i)
        {
            writeTabbed(os, columns[i]);
        }
    }

    os  << endl;
}


void Foam::functionObjects::flumeFunctionObject::writeLine
(
    Ostream& os,
    const UList<scalar>& values
) const
{
    writeCurrentTime(os);
    os  << tab;
    writeRow(os, values);
}


void Foam::functionObjects::flumeFunctionObject::writeRow
(
    Ostream& os,
    const UList<scalar>& values
) const
{
    forAll(values, i)
    {
        os  << (i ? "\t" : "") << setw(charWidth()) << values[i];
    }

    os  << endl;
}


bool Foam::functionObjects::flumeFunctionObject::execute()
{
    sampled_ = sample();
    sampledAt_ = now();
    return true;
}


bool Foam::functionObjects::flumeFunctionObject::write()
{
    if (sampledAt_ != now())
    {
        execute();
    }
    if (sampled_)
    {
        report();
    }
    return true;
}
