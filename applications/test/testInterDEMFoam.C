// SPDX-License-Identifier: GPL-3.0-or-later
// The unit tests, as a plain GoogleTest program:
//
//   Test-interDEMFoam                            all but the suites Parallel*
//   mpirun -np 2 Test-interDEMFoam -parallel     the suites Parallel*
//
// Options of GoogleTest (--gtest_filter=...) work in both. OpenFOAM's fatal
// errors are thrown as Foam::error, so that a test can expect them.

#include "Pstream.H"
#include "error.H"
#include "sigFpe.H"

#include <gtest/gtest.h>
#include <mpi.h>

#include <cstring>
#include <iostream>
#include <sstream>
#include <string>

namespace
{

//- Ranks other than the first print only failures. Each line has the name of the
//  test (validation/tools/unitTests.awk), since lines of ranks mix.
class failurePrinter
:
    public testing::EmptyTestEventListener
{
    std::string test_ = "outsideOfTests";

    void OnTestStart(const testing::TestInfo& info) override
    {
        test_ = std::string(info.test_suite_name()) + '.' + info.name();
    }

    void OnTestPartResult(const testing::TestPartResult& result) override
    {
        if (!result.failed())
        {
            return;
        }
        std::ostringstream all;
        all << (result.file_name() ? result.file_name() : "?") << ':'
            << result.line_number() << '\n' << result.message();

        std::istringstream lines(all.str());
        std::ostringstream output;
        for (std::string line; std::getline(lines, line);)
        {
            output<< "[rank " << Foam::UPstream::myProcNo() << "] " << test_
                << ": " << line << '\n';
        }
        std::cerr << output.str() << std::flush;
    }
};


//- True if -parallel was given; removes it
bool takeParallel(int& argc, char** argv)
{
    for (int i = 1; i < argc; ++i)
    {
        if (!std::strcmp(argv[i], "-parallel"))
        {
            std::copy(argv + i + 1, argv + argc + 1, argv + i);
            --argc;
            return true;
        }
    }
    return false;
}


//- The worst result of all ranks
int worst(int result)
{
    MPI_Allreduce
    (
        MPI_IN_PLACE, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD
    );
    return result;
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    const bool parallel = takeParallel(argc, argv);

    if (parallel)
    {
        Foam::UPstream::init(argc, argv, false);
    }
    else
    {
        Foam::UPstream::initNull();
    }

    testing::GTEST_FLAG(filter) = parallel ? "Parallel*" : "-Parallel*";
    testing::InitGoogleTest(&argc, argv);

    if (!Foam::UPstream::master())
    {
        auto& listeners = testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new failurePrinter);
    }

    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    Foam::sigFpe::set();

    const int result = worst(RUN_ALL_TESTS());
    Foam::UPstream::exit(result);
    return result;
}
