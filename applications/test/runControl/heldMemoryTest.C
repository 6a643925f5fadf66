// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that a run holds is released where it is free, and printed in MiB.

#include "heldMemory.H"
#include "terminalOutput.H"

#include "Pstream.H"
#include "memInfo.H"

#include <cstdio>
#include <memory>
#include <vector>

using namespace Foam;

namespace
{

//- Resident memory [MiB]
scalar resident()
{
    return memInfo().rss()/1024.0;
}


//- The two numbers of the line that is printed: of all ranks, and of the largest [MiB]
std::pair<double, double> printed()
{
    const std::string line(outputDuring(&printHeldMemory));
    double all = 0;
    double most = 0;
    EXPECT_EQ
    (
        std::sscanf
        (
            line.c_str(), "Memory [MiB]: %lf in all, %lf on one rank at most", &all, &most
        ),
        2
    ) << line;
    return {all, most};
}

} // End anonymous namespace


TEST(heldMemory, thatIsFreeGoesBackToTheSystem)
{
    // Pieces that are too small for a mapping of their own, the last one kept: what is
    // freed below it stays with the process
    std::vector<std::unique_ptr<std::vector<char>>> pieces;
    for (label i = 0; i < 2000; ++i)
    {
        pieces.push_back(std::make_unique<std::vector<char>>(50000, 'x'));
    }
    const auto last(std::move(pieces.back()));
    pieces.clear();
    const scalar before = resident();
    releaseFreeMemory();
    EXPECT_LT(resident(), before - 50);
    EXPECT_EQ(last->front(), 'x');
}


TEST(heldMemory, isPrintedInMebibytes)
{
    const auto [all, most] = printed();
    EXPECT_NEAR(all, resident(), 0.1*resident());
    EXPECT_EQ(all, most);
}


TEST(ParallelHeldMemory, isThatOfAllRanksAndOfTheLargest)
{
    if (!Pstream::master())
    {
        printHeldMemory();
        return;
    }
    const auto [all, most] = printed();
    EXPECT_GE(most, 0.9*resident());
    EXPECT_GT(all, most);
    EXPECT_LE(all, Pstream::nProcs()*most*(1 + 1e-4));
}
