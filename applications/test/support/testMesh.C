// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the box of testMesh.H: points, faces in upper-triangular order, the
// six sides, then the cuts with the neighbouring ranks.

#include "testMesh.H"
#include "OFstream.H"

namespace
{

const char* const sideNames[6] =
    {"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

const char* const controlEntries =
    "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;"
    "writeControl timeStep; writeInterval 1; writeFormat binary;"
    "timePrecision 8; runTimeModifiable false;";

const char* const schemesEntries =
    "ddtSchemes { default Euler; }"
    "gradSchemes { default Gauss linear; }"
    "divSchemes { default Gauss upwind; }"
    "laplacianSchemes { default Gauss linear corrected; }"
    "interpolationSchemes { default linear; }"
    "snGradSchemes { default corrected; }";

const char* const solutionEntries =
    "solvers { \".*\" { solver PBiCGStab; preconditioner diagonal;"
    " tolerance 1e-12; relTol 0; } }";


void writeDictionary
(
    const Foam::fileName& folder,
    const Foam::word& name,
    const char* entries
)
{
    Foam::mkDir(folder/"system");
    Foam::OFstream(folder/"system"/name)()
        << "FoamFile { version 2.0; format ascii; class dictionary; object "
        << name << "; }\n" << entries << '\n';
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::testMesh::cutSlab()
{
    const label nRanks = UPstream::parRun() ? UPstream::nProcs() : 1;
    const label rank = UPstream::parRun() ? UPstream::myProcNo() : 0;
    const label n = box_.cells[box_.cut];

    first_ = (n*rank)/nRanks;
    cells_ = box_.cells;
    cells_[box_.cut] = (n*(rank + 1))/nRanks - first_;
}


void Foam::testMesh::writeCase()
{
    writeDictionary(folder_, "controlDict", controlEntries);
    writeDictionary(folder_, "fvSchemes", schemesEntries);
    writeDictionary(folder_, "fvSolution", solutionEntries);
}


Foam::pointField Foam::testMesh::points() const
{
    const labelVector n(cells_ + labelVector::uniform(1));
    pointField points(cmptProduct(n));
    labelVector i;

    for (i.z() = 0; i.z() < n.z(); ++i.z())
    {
        for (i.y() = 0; i.y() < n.y(); ++i.y())
        {
            for (i.x() = 0; i.x() < n.x(); ++i.x())
            {
                labelVector whole(i);
                whole[box_.cut] += first_;
                point& p = points[index(i, n)];

                for (direction d = 0; d < 3; ++d)
                {
                    p[d] =
                        box_.origin[d]
                      + box_.span[d]*whole[d]/box_.cells[d];
                }
            }
        }
    }

    return points;
}


Foam::label Foam::testMesh::index(const labelVector& ijk, const labelVector& n)
{
    return ijk.x() + n.x()*(ijk.y() + n.y()*ijk.z());
}


Foam::face Foam::testMesh::cellFace
(
    const labelVector& ijk,
    const direction d,
    const bool upper
) const
{
    const labelVector n(cells_ + labelVector::uniform(1));
    labelVector base(ijk);
    base[d] += upper;

    labelVector a(base), b(base), ab(base);
    ++a[(d + 1)%3];
    ++b[(d + 2)%3];
    ++ab[(d + 1)%3];
    ++ab[(d + 2)%3];

    // The first point is the same seen from both sides, as coupled patches want
    face f(4);
    f[0] = index(base, n);
    f[1] = index(upper ? a : b, n);
    f[2] = index(ab, n);
    f[3] = index(upper ? b : a, n);
    return f;
}


void Foam::testMesh::addInternal
(
    DynamicList<face>& faces,
    DynamicList<label>& owner,
    DynamicList<label>& neighbour
) const
{
    labelVector i;

    for (i.z() = 0; i.z() < cells_.z(); ++i.z())
    {
        for (i.y() = 0; i.y() < cells_.y(); ++i.y())
        {
            for (i.x() = 0; i.x() < cells_.x(); ++i.x())
            {
                for (direction d = 0; d < 3; ++d)
                {
                    if (i[d] + 1 == cells_[d])
                    {
                        continue;
                    }
                    labelVector next(i);
                    ++next[d];
                    faces.append(cellFace(i, d, true));
                    owner.append(index(i, cells_));
                    neighbour.append(index(next, cells_));
                }
            }
        }
    }
}


Foam::label Foam::testMesh::addSide
(
    DynamicList<face>& faces,
    DynamicList<label>& owner,
    const direction side
) const
{
    const direction d = side/2;
    const bool upper = side%2;
    const direction d1 = (d == 0 ? 1 : 0);
    const direction d2 = (d == 2 ? 1 : 2);

    labelVector i;
    i[d] = upper ? cells_[d] - 1 : 0;

    for (i[d2] = 0; i[d2] < cells_[d2]; ++i[d2])
    {
        for (i[d1] = 0; i[d1] < cells_[d1]; ++i[d1])
        {
            faces.append(cellFace(i, d, upper));
            owner.append(index(i, cells_));
        }
    }

    return cells_[d1]*cells_[d2];
}


bool Foam::testMesh::isOuter(const direction side) const
{
    return UPstream::myProcNo() == (side%2 ? UPstream::nProcs() - 1 : 0);
}


bool Foam::testMesh::isCut(const direction side) const
{
    return
        UPstream::parRun()
     && side/2 == box_.cut
     && (!isOuter(side) || box_.patches[side] == "cyclic");
}


Foam::dictionary Foam::testMesh::patchEntry(const direction side) const
{
    dictionary dict;
    dict.add("type", box_.patches[side]);

    if (box_.patches[side].find("cyclic") == 0)
    {
        const direction opposite = side%2 ? side - 1 : side + 1;
        vector separation(Zero);
        separation[side/2] = (side%2 ? -1 : 1)*box_.span[side/2];

        dict.add("neighbourPatch", word(sideNames[opposite]));
        dict.add("transform", word("translational"));
        dict.add("separationVector", separation);
    }

    return dict;
}


Foam::dictionary Foam::testMesh::cutEntry
(
    const direction side,
    word& name
) const
{
    const label nRanks = UPstream::nProcs();
    const label here = UPstream::myProcNo();
    const label next = here + (side%2 ? 1 : -1);
    const label there = (next + nRanks)%nRanks;

    dictionary dict;
    dict.add("type", word("processor"));
    dict.add("myProcNo", here);
    dict.add("neighbProcNo", there);
    name = "procBoundary" + Foam::name(here) + "to" + Foam::name(there);

    if (next != there)
    {
        const word side0(sideNames[side]);
        dict.set("type", word("processorCyclic"));
        dict.add("referPatch", side0);
        name += "through" + side0;
    }

    return dict;
}


void Foam::testMesh::addPatches
(
    const wordList& names,
    const PtrList<dictionary>& entries
)
{
    PtrList<polyPatch> patches(names.size());
    forAll(names, i)
    {
        patches.set
        (
            i,
            polyPatch::New(names[i], entries[i], i, mesh_->boundaryMesh())
        );
    }
    mesh_->addFvPatches(patches);
}


void Foam::testMesh::makeMesh()
{
    DynamicList<face> faces;
    DynamicList<label> owner, neighbour;
    addInternal(faces, owner, neighbour);

    wordList names;
    PtrList<dictionary> entries;

    const auto addPatch =
        [&](const word& name, dictionary&& entry, const label size)
        {
            entry.add("startFace", faces.size() - size);
            entry.add("nFaces", size);
            names.append(name);
            entries.append(new dictionary(std::move(entry)));
        };

    for (direction side = 0; side < 6; ++side)
    {
        const label size = isCut(side) ? 0 : addSide(faces, owner, side);
        addPatch(sideNames[side], patchEntry(side), size);
    }

    // Two ranks of a periodic box share two cuts and find them by their order:
    // the one inside the box comes first on both
    for (const bool wrapped : {false, true})
    {
        for (direction side = 0; side < 6; ++side)
        {
            word name;
            if (isCut(side) && isOuter(side) == wrapped)
            {
                dictionary entry(cutEntry(side, name));
                const label size = addSide(faces, owner, side);
                addPatch(name, std::move(entry), size);
            }
        }
    }

    mesh_.reset
    (
        new fvMesh
        (
            IOobject
            (
                polyMesh::defaultRegion,
                time_->constant(),
                *time_,
                IOobject::READ_IF_PRESENT
            ),
            points(),
            faceList(std::move(faces)),
            labelList(std::move(owner)),
            labelList(std::move(neighbour))
        )
    );

    addPatches(names, entries);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::testMesh::testMesh(const testBox& box)
:
    box_(box)
{
    cutSlab();
    writeCase();
    time_.reset
    (
        new Time
        (
            Time::controlDictName,
            folder_.path(),
            fileName(folder_.name())
        )
    );
    makeMesh();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::testMesh::~testMesh()
{
    mesh_.clear();
    time_.clear();
}
