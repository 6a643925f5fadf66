// SPDX-License-Identifier: GPL-3.0-or-later
// A continuum of material points in the place of grains: its state on disk.

#include "materialPointsPhase.H"

#include "OSspecific.H"
#include "OStringStream.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "foamCompatibility.H"

#include <fstream>

Foam::fileName Foam::materialPointsPhase::stateOnDisk() const
{
    // That of the first rank, wherever the file handler keeps it
    fileName state
    (
        fileHandler().filePath(mesh_.time().timePath()/stateFolder/"state")
    );
    compatibility::broadcast(state);

    if (state.empty())
    {
        checkNoStateLost("constant/granularProperties");
    }

    return state;
}


Foam::string Foam::materialPointsPhase::heading() const
{
    OStringStream os;
    os  << "materialPoints " << pointSet::nBytes();
    for (const word& body : method_.bodies())
    {
        os  << ' ' << body;
    }
    return os.str();
}


Foam::List<char> Foam::materialPointsPhase::packed()
{
    DynamicList<char> result;
    for (label i = 0; i < size(); ++i)
    {
        method_.points().pack(i, result);
    }
    return List<char>(std::move(result));
}


bool Foam::materialPointsPhase::writeState(const fileName& folder)
{
    const fileName aside(folder/"state.incomplete");
    const List<char> mine(packed());
    labelList bytes(Pstream::nProcs());
    bytes[Pstream::myProcNo()] = mine.size();
    Pstream::gatherList(bytes);

    bool complete = true;
    if (Pstream::master())
    {
        std::ofstream os(aside, std::ios::binary);
        os  << heading() << '\n' << method_.sinceSorted() << ' '
            << sum(bytes)/pointSet::nBytes() << '\n';
        os.write(mine.cdata(), mine.size());

        // One rank at a time: no list is as long as all points
        for (label rank = 1; rank < Pstream::nProcs(); ++rank)
        {
            List<char> theirs(bytes[rank]);
            UIPstream::read
            (
                Pstream::commsTypes::blocking,
                rank,
                theirs.data(),
                theirs.size()
            );
            os.write(theirs.cdata(), theirs.size());
        }
        os.close();
        complete = os.good() && mv(aside, folder/"state");
    }
    else
    {
        UOPstream::write
        (
            Pstream::commsTypes::blocking,
            Pstream::masterNo(),
            mine.cdata(),
            mine.size()
        );
    }

    compatibility::broadcast(complete);
    return complete;
}


void Foam::materialPointsPhase::readState(const fileName& path)
{
    Info<< "    from " << path << endl;

    std::ifstream is(path, std::ios::binary);
    std::string found;
    std::getline(is, found);

    if (found != heading())
    {
        FatalErrorInFunction
            << "The state " << path << " is one of" << nl
            << "    " << found.substr(0, 200).c_str() << nl
            << "    but the dictionary has" << nl
            << "    " << heading().c_str() << nl
            << "    Go on with the bodies, and the version of this program,"
            << " that wrote it." << exit(FatalError);
    }

    label sinceSorted = 0;
    label n = 0;
    is >> sinceSorted >> n;
    is.get();

    // All ranks read all points, and each keeps its own
    pointSet& points = method_.points();
    List<char> bytes(pointSet::nBytes());
    pointSet one;

    for (label i = 0; i < n && is; ++i)
    {
        is.read(bytes.data(), bytes.size());
        one.resize(0);
        one.unpack(bytes);

        const label cell =
            pointGrid::cell(method_.grid().coordinate(one.x[0], 0));
        if (method_.grid().rankOf(cell) == Pstream::myProcNo())
        {
            points.unpack(bytes);
        }
    }

    if (!is || nTotal() != n)
    {
        FatalErrorInFunction
            << "The state " << path << " breaks off, or has points that are not"
            << " in the mesh: " << nTotal() << " of " << n << " were taken." << nl
            << "    Go on from the time before it." << exit(FatalError);
    }

    method_.goOn(sinceSorted);
}
