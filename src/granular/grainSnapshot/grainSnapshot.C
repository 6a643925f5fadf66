// SPDX-License-Identifier: GPL-3.0-or-later
// The grains at one moment: where they come from, and the cloud that holds
// them in a time folder.

#include "grainSnapshot.H"

#include "IOField.H"
#include "Time.H"
#include "clumpSums.H"
#include "exceptionGuard.H"
#include "foamCompatibility.H"
#include "OSspecific.H"
#include "functionObject.H"
#include "granularPhase.H"
#include "mathematicalConstants.H"
#include "passiveParticleCloud.H"

const Foam::word Foam::grainSnapshot::cloudName("grains");

namespace
{

using namespace Foam;

const string wallPrefix("wallForce.");


fileName cloudFolder()
{
    return cloud::prefix/grainSnapshot::cloudName;
}


IOobject fieldIO
(
    const fvMesh& mesh,
    const word& name,
    const IOobject::readOption r
)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        cloudFolder(),
        mesh,
        r,
        IOobject::NO_WRITE,
        false
    );
}


//- Write as controlDict sets; true where nothing is missing on the disk.
//  OpenFOAM's own write does not see a disk that fills with the last buffer,
//  so the stream is kept here, but for collated files, which have no file of
//  their own
bool writeChecked(const regIOobject& io, const bool valid)
{
    if (fileHandler().type() != "uncollated")
    {
        return io.write(valid);
    }

    if (!valid)
    {
        return true;
    }

    const Time& time = io.time();
    const fileName path(io.objectPath());

    mkDir(path.path());

    compatibility::outputFile os
    (
        path,
        time.writeFormat(),
        time.writeCompression()
    );

    // OpenFOAM ends the program where a list cannot be written
    bool ok = os.good();

    try
    {
        const exceptionGuard guard(FatalIOError);
        ok = ok && io.writeHeader(os) && io.writeData(os);
        IOobject::writeEndDivider(os);
        os.flush();
    }
    catch (const IOerror&)
    {
        ok = false;
    }

    return ok && os.stdStream().good();
}


template<class Type>
bool writeField
(
    const fvMesh& mesh,
    const word& name,
    const Field<Type>& values
)
{
    const IOField<Type> field(fieldIO(mesh, name, IOobject::NO_READ), values);

    return writeChecked(field, values.size());
}


bool writeField(const fvMesh& mesh, const word& name, const labelList& values)
{
    return writeField<label>(mesh, name, labelField(values));
}


template<class Type>
void readField
(
    const fvMesh& mesh,
    const word& name,
    Field<Type>& values
)
{
    IOField<Type> field
    (
        fieldIO(mesh, name, IOobject::MUST_READ),
        values.size() > 0
    );

    if (field.size() != values.size())
    {
        FatalErrorInFunction
            << "Field " << field.objectPath() << " has " << field.size()
            << " values for " << values.size() << " grains." << nl
            << "    The cloud was not written completely: remove this time"
            << " and take the one before it." << exit(FatalError);
    }

    values.transfer(field);
}


void readField(const fvMesh& mesh, const word& name, labelList& values)
{
    labelField field(values.size());
    readField<label>(mesh, name, field);
    values.transfer(field);
}


//- Names of walls, the same on all ranks: one that has no grain has no list
wordList allNames(wordList names)
{
    List<wordList> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = names;
    Pstream::gatherList(all);
    compatibility::broadcast(all);

    wordHashSet united;
    for (const wordList& some : all)
    {
        united.insert(some);
    }

    return united.sortedToc();
}


//- True where the written grains have a field, on any rank
bool isOnDisk(const fvMesh& mesh, const word& field)
{
    const fileName path
    (
        fileHandler().filePath
        (
            mesh.time().timePath()/mesh.dbDir()/cloudFolder()/field
        )
    );

    return returnReduce(!path.empty(), orOp<bool>());
}


//- Fatal where clumps were written without a field
void checkField(const fvMesh& mesh, const word& field)
{
    if (!isOnDisk(mesh, field))
    {
        FatalErrorInFunction
            << "The grains of time " << mesh.time().timeName()
            << " are clumps, but lack the field " << field << " in "
            << cloudFolder() << "." << nl
            << "    A version without it wrote them: run the case again, or take this"
            << " time out." << exit(FatalError);
    }
}


wordList wallsOnDisk(const fvMesh& mesh)
{
    DynamicList<word> walls;

    // Collated files are in the folder of all ranks. No folder: no grain here
    const fileName folder
    (
        fileHandler().filePath
        (
            mesh.time().timePath()/mesh.dbDir()/cloudFolder()
        )
    );

    for
    (
        const fileName& name
      : folder.empty() ? fileNameList() : readDir(folder, fileName::FILE)
    )
    {
        if (name.starts_with(wallPrefix))
        {
            walls.append(name.substr(wallPrefix.size()));
        }
    }

    return walls;
}


//- Positions, as cells and weights (coordinates: OpenFOAM) and as points
//  (positions: ParaView's reader)
bool writePositions
(
    const fvMesh& mesh,
    const vectorField& position,
    const labelUList& cells
)
{
    Cloud<passiveParticle> grains
    (
        mesh,
        grainSnapshot::cloudName,
        IDLList<passiveParticle>()
    );

    forAll(position, i)
    {
        grains.append(new passiveParticle(mesh, position[i], cells[i]));
    }

    const bool valid = position.size();
    bool ok = true;

    for
    (
        const auto geometry
      : {cloud::geometryType::COORDINATES, cloud::geometryType::POSITIONS}
    )
    {
        const IOPosition<Cloud<passiveParticle>> io(grains, geometry);
        ok = writeChecked(io, valid) && ok;
    }

    return ok;
}


void checkCells
(
    const fvMesh& mesh,
    const grainSnapshot& grains,
    const labelUList& cells
)
{
    if (cells.size() != grains.size())
    {
        FatalErrorInFunction
            << cells.size() << " cells for " << grains.size() << " grains: "
            << "each grain needs the cell that holds it."
            << exit(FatalError);
    }

    forAll(cells, i)
    {
        if (cells[i] < 0 || cells[i] >= mesh.nCells())
        {
            FatalErrorInFunction
                << "Grain " << grains.id[i] << " at " << grains.position[i]
                << " lies in no cell of this rank, so it cannot be written"
                << " (cell " << cells[i] << " of " << mesh.nCells() << ")."
                << exit(FatalError);
        }
    }
}

} // End anonymous namespace


Foam::grainSnapshot::grainSnapshot(const label n)
:
    clump(n, Zero),
    position(n, Zero)
{
    forEachField([this, n](const char*, const auto member)
    {
        auto& list = this->*member;
        list = std::decay_t<decltype(list)>(n, Zero);
    });
}


Foam::autoPtr<Foam::grainSnapshot> Foam::grainSnapshot::New(const fvMesh& mesh)
{
    const auto* running =
        mesh.cfindObject<granularPhase>(granularPhase::typeName);

    if (running && !functionObject::postProcess)
    {
        return running->snapshot();
    }

    return read(mesh);
}


Foam::autoPtr<Foam::grainSnapshot> Foam::grainSnapshot::read
(
    const fvMesh& mesh
)
{
    // Reads the positions; a rank without grains has no file and stays empty
    const passiveParticleCloud cloud(mesh, cloudName, false);

    auto result = autoPtr<grainSnapshot>::New(cloud.size());
    grainSnapshot& grains = *result;

    label i = 0;
    for (const passiveParticle& p : cloud)
    {
        grains.position[i++] = p.position();
    }

    if (!returnReduce(grains.size(), sumOp<label>()))
    {
        return result;
    }

    const auto readInto = [&](const char* name, const auto member)
    {
        auto& list = grains.*member;
        list.setSize(cloud.size());
        readField(mesh, name, list);
    };
    forEachField(readInto);

    if (isOnDisk(mesh, "clump"))
    {
        forEachClumpField([&](const char* name, const auto member)
        {
            // No function object reads these two, and version 0.4 did not write them
            if (word(name) != "orientation" && word(name) != "axes")
            {
                checkField(mesh, name);
            }
            if (isOnDisk(mesh, name))
            {
                readInto(name, member);
            }
        });
    }

    for (const word& wall : allNames(wallsOnDisk(mesh)))
    {
        vectorField& values = grains.wallForce(wall);
        values.setSize(grains.size(), Zero);
        readField(mesh, wallPrefix + wall, values);
    }

    return result;
}


bool Foam::grainSnapshot::write
(
    const fvMesh& mesh,
    const labelUList& cells
) const
{
    checkCells(mesh, *this, cells);

    bool ok = writePositions(mesh, position, cells);

    const auto writeFrom = [&](const char* name, const auto member)
    {
        ok = writeField(mesh, name, this->*member) && ok;
    };
    forEachField(writeFrom);

    const bool clumps = hasClumps();
    forEachClumpField([&](const char* name, const auto member)
    {
        if (clumps)
        {
            writeFrom(name, member);
        }
        else
        {
            // Of a run before in this folder
            rm(fieldIO(mesh, name, IOobject::NO_READ).objectPath());
        }
    });

    for (const word& wall : allNames(wallForce.toc()))
    {
        const vectorField values
        (
            wallForce.lookup(wall, vectorField(size(), Zero))
        );
        ok = writeField(mesh, wallPrefix + wall, values) && ok;
    }

    return returnReduce(ok, andOp<bool>());
}


Foam::scalar Foam::grainSnapshot::volume(const label i) const
{
    return partOfBody(i)*constant::mathematical::pi*pow3(bodyDiameter(i))/6;
}


bool Foam::grainSnapshot::hasClumps() const
{
    bool here = false;
    for (const label c : clump)
    {
        here = here || c;
    }

    return returnReduce(here, orOp<bool>());
}


Foam::label Foam::grainSnapshot::nBodies() const
{
    label nAlone = 0;
    for (const label c : clump)
    {
        nAlone += !c;
    }

    return returnReduce(nAlone, sumOp<label>()) + nClumps(clump);
}
