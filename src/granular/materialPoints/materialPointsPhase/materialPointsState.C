// SPDX-License-Identifier: GPL-3.0-or-later
// A continuum of material points in the place of grains: snapshots, writing and reading.

#include "materialPointsPhase.H"

#include "OSspecific.H"
#include "OStringStream.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "foamCompatibility.H"
#include "grainSnapshot.H"
#include "keywords.H"

#include <fstream>
#include <sstream>

namespace
{
    using namespace Foam;

    //- Points that are written at once: neither the memory that this takes nor
    //  a message grows with their number
    constexpr label pieceOfState = 32768;

    //- Points of another rank as bytes, on the first
    List<char> received(const label rank, const label nPoints)
    {
        // Scheduled: what is blocking must fit a buffer of 20 MB
        List<char> result(nPoints*pointSet::nBytes());
        const auto nBytes = UIPstream::read
        (
            Pstream::commsTypes::scheduled,
            rank,
            result.data(),
            result.size()
        );

        if (nBytes != result.size())
        {
            FatalErrorInFunction
                << "Rank " << rank << " was to send " << result.size()
                << " bytes of the state of its points; " << nBytes
                << " came." << nl
                << "    Continue from the last complete time." << exit(FatalError);
        }
        return result;
    }


    //- Points of this rank as bytes, to the first
    void send(const List<char>& bytes)
    {
        const bool sent = UOPstream::write
        (
            Pstream::commsTypes::scheduled,
            Pstream::masterNo(),
            bytes.cdata(),
            bytes.size()
        );

        if (!sent)
        {
            FatalErrorInFunction
                << "The state of the points of rank " << Pstream::myProcNo()
                << ", " << bytes.size() << " bytes, could not be sent to the"
                << " first rank, which writes it." << nl
                << "    Continue from the last complete time." << exit(FatalError);
        }
    }


    //- First line of a state: what must be the same to go on from it. Points keep their
    //  mass, so that another density would be taken for a change of volume
    string heading(const materialPointMethod& method)
    {
        OStringStream os;
        os.precision(15);
        os  << "materialPoints " << pointSet::nBytes();
        forAll(method.bodies(), body)
        {
            os  << ' ' << method.bodies()[body] << ' '
                << method.laws()[body].density();
        }
        return os.str();
    }


    //- A piece of the points of this rank, from number begin on, as bytes
    List<char> packed(pointSet& points, const label begin)
    {
        DynamicList<char> result;
        for (label i = begin; i < min(begin + pieceOfState, points.size()); ++i)
        {
            points.pack(i, result);
        }
        return List<char>(std::move(result));
    }
}


Foam::fileName Foam::materialPointsPhase::stateOnDisk() const
{
    // That of the first rank, wherever the file handler keeps it
    fileName state
    (
        fileHandler().filePath(mesh_.time().timePath()/stateFolder/stateName_)
    );
    compatibility::broadcast(state);

    if (state.empty())
    {
        checkNoStateLost("constant/granularProperties", stateName_);
    }

    return state;
}


bool Foam::materialPointsPhase::writeState(const fileName& folder)
{
    const fileName aside(folder/(stateName_ + ".incomplete"));
    const label mine = method_.points().size();
    labelList n(Pstream::nProcs());
    n[Pstream::myProcNo()] = mine;
    Pstream::gatherList(n);

    bool complete = true;
    if (Pstream::master())
    {
        std::ofstream os(aside, std::ios::binary);
        os  << heading(method_) << '\n' << method_.sinceSorted() << ' ' << sum(n);
        if (method_.gateSide())
        {
            os.precision(17);
            os  << ' ' << method_.gateSide() << ' ' << now_;
            for (const vector& v : {gate_.onPlane(), gate_.normal()})
            {
                os  << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
            }
        }
        os  << '\n';

        forAll(n, rank)
        {
            for (label begin = 0; begin < n[rank]; begin += pieceOfState)
            {
                const List<char> piece
                (
                    rank == Pstream::masterNo()
                  ? packed(method_.points(), begin)
                  : received(rank, min(pieceOfState, n[rank] - begin))
                );
                os.write(piece.cdata(), piece.size());
            }
        }
        os.close();
        complete = os.good() && mv(aside, folder/stateName_);
    }
    else
    {
        for (label begin = 0; begin < mine; begin += pieceOfState)
        {
            send(packed(method_.points(), begin));
        }
    }

    compatibility::broadcast(complete);
    return complete;
}


void Foam::materialPointsPhase::readGate(std::istream& numbers)
{
    label side = 0;
    scalar time = 0;
    vector p(Zero);
    vector normal(Zero);
    if
    (
        gate_.exists()
     && numbers >> side >> time >> p.x() >> p.y() >> p.z()
     && numbers >> normal.x() >> normal.y() >> normal.z()
    )
    {
        // Of a gate in another place the side is found again
        const bool same =
            mag(p - gate_.onPlane()) < 1e-9*(1 + mag(p))
         && mag(normal - gate_.normal()) < 1e-9;
        gateSide_ = same ? side : 0;

        // The same bits as without a stop; a state may also begin another run
        if (mag(time - now_) < 1e-3*exchangeInterval())
        {
            now_ = time;
        }
    }
}


void Foam::materialPointsPhase::readState(const fileName& path)
{
    Info<< "    from " << path << endl;

    std::ifstream is(path, std::ios::binary);
    std::string line;
    std::getline(is, line);

    if (line != heading(method_))
    {
        FatalErrorInFunction
            << "The state " << path << " is one of" << nl
            << "    " << line.substr(0, 200).c_str() << nl
            << "    but the dictionary has" << nl
            << "    " << heading(method_).c_str() << nl
            << "    Go on with the bodies, the 'density' of each, and the version of this"
            << " program that wrote it." << exit(FatalError);
    }

    label sinceSorted = 0;
    label n = 0;
    std::getline(is, line);
    std::istringstream numbers(line);
    numbers >> sinceSorted >> n;
    readGate(numbers);

    // All ranks read all points, and each keeps its own
    pointSet& points = method_.points();
    List<char> bytes(pointSet::nBytes());
    pointSet one;

    for (label i = 0; i < n && is; ++i)
    {
        is.read(bytes.data(), bytes.size());
        one.resize(0);
        one.unpack(bytes);

        const pointGrid& grid = method_.grid();
        const label cell = pointGrid::cell(grid.coordinate(one.x[0], 0));
        if (grid.holds(one.x[0]) && grid.rankOf(cell) == Pstream::myProcNo())
        {
            points.unpack(bytes);
        }
    }

    const label taken = returnReduce(points.size(), sumOp<label>());
    if (!is || taken != n)
    {
        FatalErrorInFunction
            << "The state " << path << " breaks off, or has points that are not"
            << " in the mesh: " << taken << " of " << n << " were taken." << nl
            << "    Go on from the time before it." << exit(FatalError);
    }

    method_.restoreSorting(sinceSorted);
}


Foam::dictionary Foam::materialPointsPhase::activePhysics() const
{
    dictionary result(granularPhase::activePhysics());

    for
    (
        const char* key
      : {
            "cellSize", "pointsPerCell", "seed", "courant", "averaging",
            "densityAveraging", "shifting", "sideWalls"
        }
    )
    {
        if (dict_.found(key))
        {
            result.add(*dict_.findEntry(key, keyType::LITERAL));
        }
    }
    result.add("transfer", keywords::sub(dict_, "transfer"));
    result.add("walls", keywords::sub(dict_, "walls"));
    result.add("contact", keywords::sub(dict_, "contact"));
    result.add("bodies", keywords::sub(dict_, "bodies"));
    if (gate_.exists())
    {
        result.add("gate", gateMotion::settings(mesh_));
    }

    return result;
}


Foam::autoPtr<Foam::grainSnapshot> Foam::materialPointsPhase::snapshot() const
{
    auto result = autoPtr<grainSnapshot>::New(method_.points().size());
    grainSnapshot& grains = *result;
    const pointSet& p = method_.points();

    grains.id = p.id;
    grains.position = p.x;
    grains.U = p.U;
    grains.omega = asGrains_.halfCurl;
    grains.mass = p.mass;
    grains.force = p.force;

    forAll(p.x, i)
    {
        grains.type[i] = p.body[i] + 1;
        grains.d[i] = 2*asGrains_.radius[i];
        grains.contactForce[i] =
            asGrains_.meanForce[i] - p.force[i] - p.mass[i]*g_;
        grains.stressMoment[i] = p.volume[i]*p.stress[i];
    }

    const wordList& walls = method_.walls().names();
    const List<vectorField> impulses(method_.wallImpulses());
    forAll(walls, wall)
    {
        grains.wallForce.insert
        (
            walls[wall],
            vectorField(impulses[wall]/exchangeInterval())
        );
    }

    return result;
}
