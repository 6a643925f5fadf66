// SPDX-License-Identifier: GPL-3.0-or-later
// The past of all grains on disk, written and read in pieces.

#include "historyForce.H"

#include "IFstream.H"
#include "IPstream.H"
#include "OFstream.H"
#include "OPstream.H"
#include "OSspecific.H"
#include "foamCompatibility.H"

namespace
{

using namespace Foam;

//- The file of the past, in the folder of the grains' state: interval and window, a list
//  of pieces with the numbers of grains, and a list of as many pieces with their vectors
const word fileOfPast("history");

//- Grains that are written, sent or read at once: some MB, however many there are
constexpr label grainsOfPiece = 8192;

constexpr Pstream::commsTypes oneByOne = Pstream::commsTypes::scheduled;


//- The list of pieces, so many of each rank, through the first rank, which has the file
template<class Piece, class Function>
void writePieces(autoPtr<OFstream>& os, const labelList& nPieces, const Function& piece)
{
    if (!Pstream::master())
    {
        for (label i = 0; i < nPieces[Pstream::myProcNo()]; ++i)
        {
            OPstream toMaster(oneByOne, Pstream::masterNo());
            toMaster << piece(i);
        }
        return;
    }

    os() << nl << sum(nPieces) << nl << token::BEGIN_LIST;
    forAll(nPieces, rank)
    {
        for (label i = 0; i < nPieces[rank]; ++i)
        {
            if (rank == Pstream::masterNo())
            {
                os() << nl << piece(i);
            }
            else
            {
                IPstream fromRank(oneByOne, rank);
                os() << nl << Piece(fromRank);
            }
        }
    }
    os() << nl << token::END_LIST << nl;
}


//- Each piece in turn on all ranks, where the first reads the file. Calls
//  take(number of the piece, piece)
template<class Piece, class Function>
void readPieces(autoPtr<IFstream>& is, const Function& take)
{
    label nPieces = 0;
    if (Pstream::master())
    {
        is() >> nPieces;
        is().readBegin("pieces");
    }
    compatibility::broadcast(nPieces);
    for (label i = 0; i < nPieces; ++i)
    {
        Piece piece;
        if (Pstream::master())
        {
            is() >> piece;
        }
        compatibility::broadcast(piece);
        take(i, piece);
    }
    if (Pstream::master())
    {
        is().readEnd("pieces");
    }
}

} // End anonymous namespace


bool Foam::historyForce::write(const fileName& folder) const
{
    if (!isOn())
    {
        return true;
    }

    const List<label> ids(past_.sortedToc());
    labelList nPieces(Pstream::nProcs());
    nPieces[Pstream::myProcNo()] = (ids.size() + grainsOfPiece - 1)/grainsOfPiece;
    Pstream::gatherList(nPieces);

    const auto idsOf = [&ids](const label i) -> labelList
    {
        const label first = i*grainsOfPiece;
        return SubList<label>(ids, min(grainsOfPiece, ids.size() - first), first);
    };
    const auto numbersOf = [&](const label i) -> vectorList
    {
        DynamicList<vector> numbers;
        for (const label id : idsOf(i))
        {
            numbers.append(past_[id]);
        }
        return vectorList(std::move(numbers));
    };

    const fileName aside(folder/fileOfPast + ".incomplete");
    autoPtr<OFstream> os;
    if (Pstream::master())
    {
        os.reset(new OFstream(aside, IOstream::BINARY));
        os() << scalarList({interval_, window_});
    }
    writePieces<labelList>(os, nPieces, idsOf);
    writePieces<vectorList>(os, nPieces, numbersOf);
    if (!Pstream::master())
    {
        return true;
    }

    os().flush();
    const bool complete = os().good();
    os.clear();
    return complete && mv(aside, folder/fileOfPast);
}


void Foam::historyForce::read(const fileName& folder)
{
    if (!isOn())
    {
        return;
    }

    scalarList times(2, Zero);
    autoPtr<IFstream> is;
    if (Pstream::master() && isFile(folder/fileOfPast, false))
    {
        is.reset(new IFstream(folder/fileOfPast, IOstream::BINARY));
        is() >> times;
    }
    compatibility::broadcast(times);
    readInterval_ = times[0];
    if (times[1] != window_)
    {
        Info<< "History force: no past of this window is in " << folder
            << "; it starts again from zero" << endl;
        return;
    }

    // Each rank takes a share, and follow() brings it to the cells of the grains
    const label nRanks = Pstream::nProcs();
    const label me = Pstream::myProcNo();
    DynamicList<label> nOfPiece;
    DynamicList<labelList> ours;
    readPieces<labelList>(is, [&](const label, const labelList& ids)
    {
        DynamicList<label> some(ids.size()/nRanks + 1);
        for (label i = me; i < ids.size(); i += nRanks)
        {
            some.append(ids[i]);
        }
        nOfPiece.append(ids.size());
        ours.append(labelList(std::move(some)));
    });
    readPieces<vectorList>(is, [&](const label piece, const vectorList& numbers)
    {
        const label width = numbers.size()/max(nOfPiece[piece], label(1));
        forAll(ours[piece], i)
        {
            const label grain = me + i*nRanks;
            const SubList<vector> past(numbers, width, grain*width);
            past_.insert(ours[piece][i], vectorList(past));
        }
    });
}
