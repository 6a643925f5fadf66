// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the packings of system/packingDict and writes them as one LIGGGHTS data
// file, constant/grains/data (without that folder constant/grains.data), clumps as
// constant/grains/clumps and clumpTemplates, with constant/packingProperties beside
// the folder. Without a single sphere, constant/grains/box stands for the data.

#include "clumpRelaxation.H"
#include "grainsData.H"
#include "packingCache.H"

#include "Time.H"
#include "IOdictionary.H"
#include "argList.H"
#include "pointIOField.H"
#include "projectVersion.H"
#include "serialTool.H"
#include "uniformDimensionedFields.H"

#include <cctype>
#include <fstream>
#include <limits>
#include <sstream>

namespace Foam
{

//- The packing with its name and what it became
struct namedPacking
{
    word name;
    autoPtr<packingModel> model;
    packedGrains grains;
};


//- Gravity of the case [m/s^2]; zero where there is no constant/g, which is
//  an error only for packings that need it
vector readGravity(const Time& runTime)
{
    IOobject io
    (
        "g",
        runTime.constant(),
        runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    return
        io.typeHeaderOk<uniformDimensionedVectorField>(true)
      ? uniformDimensionedVectorField(io).value()
      : vector(Zero);
}


//- The entry "domain", or else the bounds of the mesh
boundBox readDomain(const dictionary& dict, const Time& runTime)
{
    if (dict.found("domain"))
    {
        ITstream& is = dict.lookup("domain");
        return boundBox(is);
    }

    IOobject io
    (
        "points",
        runTime.constant(),
        "polyMesh",
        runTime,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!io.typeHeaderOk<pointIOField>(true))
    {
        FatalIOErrorInFunction(dict)
            << "The box of the grains is not known: there is no mesh in "
            << runTime.constantPath()/"polyMesh" << ". Run blockMesh first,"
            << " or give the entry domain (min) (max);" << exit(FatalIOError);
    }
    return boundBox(pointIOField(io), false);
}


//- Fatal where LIGGGHTS does not take the name of a packing for that of a template
void checkName(const dictionary& dict, const word& name)
{
    for (const char c : name)
    {
        if (!std::isalnum(c) && c != '_')
        {
            FatalIOErrorInFunction(dict)
                << "The packing of clumps " << name << " has a name with '" << c
                << "' in it, which LIGGGHTS does not take." << nl
                << "    Name it with letters, digits and _ alone."
                << exit(FatalIOError);
        }
    }
}


PtrList<namedPacking> makePackings(const dictionary& dict, const vector& g)
{
    PtrList<namedPacking> packings;

    for (const entry& e : dict)
    {
        if (e.isDict())
        {
            Info<< "Packing " << e.keyword() << endl;
            autoPtr<namedPacking> next(new namedPacking);
            next->name = e.keyword();
            next->model = packingModel::New(e.dict(), g);
            if (next->model->clump())
            {
                checkName(dict, next->name);
            }
            next->grains = packingCache::obtain(next->model());
            packings.append(next.ptr());
        }
    }

    if (packings.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No packing in here: give each a name and a sub-dictionary,"
            << " for instance bed { type settled; ... }" << exit(FatalIOError);
    }
    return packings;
}


//- Directions in which a packing is periodic, which it must then fill
FixedList<bool, 3> periodicDirections
(
    const dictionary& dict,
    const UPtrList<namedPacking>& packings,
    const boundBox& domain
)
{
    FixedList<bool, 3> periodic(false);
    const scalar tolerance = 1e-9*domain.mag();

    for (const namedPacking& packing : packings)
    {
        const packingBox box(packing.model->box());
        for (direction d = 0; d < 3; ++d)
        {
            const bool fills =
                mag(box.bounds().min()[d] - domain.min()[d]) < tolerance
             && mag(box.bounds().max()[d] - domain.max()[d]) < tolerance;

            if (box.periodic(d) && !fills)
            {
                FatalIOErrorInFunction(dict)
                    << "The packing " << packing.name << " is periodic in "
                    << char('x' + d) << " and must fill the domain "
                    << domain << " there; it fills " << box.bounds()
                    << exit(FatalIOError);
            }
            periodic[d] = periodic[d] || box.periodic(d);
        }
    }
    return periodic;
}


void checkInside
(
    const dictionary& dict,
    const namedPacking& packing,
    const boundBox& domain
)
{
    boundBox tolerant(domain);
    tolerant.inflate(1e-9);
    const boundBox box(packing.model->box().bounds());

    if (!tolerant.contains(box))
    {
        FatalIOErrorInFunction(dict)
            << "The packing " << packing.name << " in the box " << box
            << " is not inside the domain " << domain << ". Move or shrink the box, or"
            << " enlarge the domain" << exit(FatalIOError);
    }
}


//- Grains of different packings must not overlap
void checkApart
(
    const dictionary& dict,
    const UPtrList<namedPacking>& packings,
    const packingBox& box
)
{
    pointField centres;
    scalarField diameters;
    labelList number;
    forAll(packings, i)
    {
        const packingModel& model = *packings[i].model;
        centres.append(model.sphereCentres(packings[i].grains));
        diameters.append(model.sphereDiameters(packings[i].grains));
        number.append(labelList(centres.size() - number.size(), i));
    }

    for (const grainPair& pair : pairsOfBodies(box, centres, diameters, number, 0))
    {
        const label a = number[pair.first];
        const label b = number[pair.second];
        if (a != b)
        {
            FatalIOErrorInFunction(dict)
                << "A grain of " << packings[a].name << " at "
                << centres[pair.first] << " overlaps one of "
                << packings[b].name << " at " << centres[pair.second]
                << ": the boxes of packings must not overlap"
                << exit(FatalIOError);
        }
    }
}


//- All spheres in the order of the dictionary; all grains checked against each other
packedGrains joined
(
    const dictionary& dict,
    const UPtrList<namedPacking>& packings,
    const boundBox& domain
)
{
    packedGrains all;
    for (const namedPacking& packing : packings)
    {
        checkInside(dict, packing, domain);
        if (!packing.model->clump())
        {
            all.append(packing.grains);
        }
    }

    const packingBox box(domain, periodicDirections(dict, packings, domain));
    checkApart(dict, packings, box);
    return all;
}


//- Write a text to a file that replaces an earlier one. Fatal where it is not complete
void writeText(const fileName& file, const std::string& text)
{
    const fileName aside(file + ".incomplete");
    std::ofstream os(aside);
    os << text;
    os.close();
    if (!os || !mv(aside, file))
    {
        FatalErrorInFunction
            << "Could not write " << file
            << ": is the disk full, may the folder be written to?" << exit(FatalError);
    }
}


//- Write the clumps of all packings and the LIGGGHTS commands for their templates to
//  files whose names begin so; none of an earlier call remains. Returns how many
label writeClumps(const UPtrList<namedPacking>& packings, const string& path)
{
    DynamicList<placedClump> clumps;
    std::ostringstream templates;
    templates.precision(std::numeric_limits<scalar>::max_digits10);
    templates << "# Templates of the clumps of preparePacking\n";
    label n = 0;

    for (const namedPacking& packing : packings)
    {
        const packingModel& model = *packing.model;
        if (model.clump())
        {
            clumps.append(placedClumps(packing.name, packing.grains));
            model.clump()->writeTemplate
            (
                templates, packing.name, model.material(), model.density(), ++n
            );
        }
    }

    rm(path + "clumps");
    rm(path + "clumpTemplates");
    if (n)
    {
        writeClumpTable(path + "clumps", clumps);
        writeText(path + "clumpTemplates", templates.str());
    }
    return clumps.size();
}


//- Write the spheres, or where all grains are clumps LIGGGHTS's commands for their box:
//  it reads no data without a grain. What an earlier call wrote is replaced
void writeSpheres
(
    const packedGrains& grains,
    const boundBox& domain,
    const label nMaterials,
    const string& path
)
{
    rm(path + "data");
    rm(path + "box");
    if (grains.size())
    {
        const fileName file(path + "data");
        writeGrainsData(file, grains, domain, "Grains of preparePacking", nMaterials);
        Info<< nl << grains.size() << " grains written to " << file << nl;
        return;
    }

    std::ostringstream os;
    os.precision(std::numeric_limits<scalar>::max_digits10);
    os << "# The box of the grains of preparePacking\nregion preparePacking block";
    for (direction d = 0; d < 3; ++d)
    {
        os << ' ' << domain.min()[d] << ' ' << domain.max()[d];
    }
    os << " units box\ncreate_box " << nMaterials << " preparePacking\n";
    writeText(path + "box", os.str());
}


//- Most materials of the packings, and of the dictionary
label nMaterials(const dictionary& dict, const UPtrList<namedPacking>& packings)
{
    label n = dict.getOrDefault<label>("materials", 1);
    for (const namedPacking& packing : packings)
    {
        n = max(n, packing.model->material());
    }
    return n;
}


//- Number of the first sphere of each packing: LIGGGHTS numbers spheres by
//  themselves first, those of clumps behind them
labelList firstIds(const UPtrList<namedPacking>& packings)
{
    labelList first(packings.size());
    label next = 1;
    for (const bool clumps : {false, true})
    {
        forAll(packings, i)
        {
            const packingModel& model = *packings[i].model;
            if (bool(model.clump()) == clumps)
            {
                first[i] = next;
                next += model.sphereGrains(packings[i].grains).size();
            }
        }
    }
    return first;
}


//- Write constant/packingProperties and show it
void report(const UPtrList<namedPacking>& packings, const Time& runTime)
{
    IOdictionary properties
    (
        IOobject
        (
            "packingProperties",
            runTime.constant(),
            runTime,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    const labelList first(firstIds(packings));
    forAll(packings, i)
    {
        const namedPacking& packing = packings[i];
        dictionary reached(packing.model->properties(packing.grains));
        reached.add("firstId", first[i]);

        Info<< nl << packing.name << nl;
        reached.write(Info, false);
        properties.add(packing.name, reached);
    }

    const unsigned digits = IOstream::defaultPrecision(12);
    properties.regIOobject::write();
    IOstream::defaultPrecision(digits);
}

} // End namespace Foam


int main(int argc, char* argv[])
{
    using namespace Foam;

    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Make packings of grains of a given solid fraction, mass or level"
        " and write them as a LIGGGHTS data file. See README.md beside the"
        " source."
    );
    argList::noParallel();
    argList::addOption("dict", "file", "Instead of system/packingDict");

    // OpenFOAM starts MPI, which LIGGGHTS needs, so that it also ends it
    startSerialTool();
    const argList args(argc, argv);
    Time runTime(Time::controlDictName, args);

    const word dictName("packingDict");
    #include "setSystemRunTimeDictionaryIO.H"
    const IOdictionary dict(dictIO);
    const boundBox domain(readDomain(dict, runTime));
    const PtrList<namedPacking> packings
    (
        makePackings(dict, readGravity(runTime))
    );

    const packedGrains grains(joined(dict, packings, domain));
    const fileName folder(runTime.path()/runTime.constant());

    // In constant itself OpenFOAM's postProcess misses a header in it; cases that
    // have their scripts there read it there
    const string path(folder + (isDir(folder/"grains") ? "/grains/" : "/grains."));
    report(packings, runTime);
    writeSpheres(grains, domain, nMaterials(dict, packings), path);
    const label nClumps = writeClumps(packings, path);
    if (nClumps)
    {
        Info<< nClumps << " clumps written to " << fileName(path + "clumps") << nl;
    }
    Info<< endl;
    return 0;
}
