// SPDX-License-Identifier: GPL-3.0-or-later
// One LIGGGHTS inside this program: opens it, gives it commands, closes it.

#include "liggghtsInstance.H"

#include "OSspecific.H"
#include "Pstream.H"
#include "fpeGuard.H"

#include <mpi.h>

#include <climits>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <iostream>

#include <liggghts/lammps.h>
#include <liggghts/library.h>
#include <liggghts/timer.h>
#include <liggghts/update.h>
#include <liggghts/integrate.h>

namespace
{
    // What showWhyItStopped() needs after main() has ended
    std::string logPath;
    std::string busyWith;

    //- Names what LIGGGHTS is doing while it does it
    struct nowDoing
    {
        explicit nowDoing(const std::string& what)
        {
            busyWith = what;
        }

        ~nowDoing()
        {
            busyWith.clear();
        }
    };

    //- Holds back std::cerr: a second LIGGGHTS in one program enters the same
    //  contact models once more, and complains of each, though all is well
    class quietErrors
    {
        std::streambuf* const shown_ = std::cerr.rdbuf(nullptr);

        quietErrors(const quietErrors&) = delete;
        void operator=(const quietErrors&) = delete;

    public:

        quietErrors() = default;

        ~quietErrors()
        {
            std::cerr.rdbuf(shown_);
        }
    };

    //- A serial OpenFOAM run starts no MPI, and LIGGGHTS needs it
    void finaliseMPI()
    {
        int done = 0;
        MPI_Finalized(&done);
        if (!done)
        {
            MPI_Finalize();
        }
    }

    void initialiseMPI()
    {
        int done = 0;
        MPI_Initialized(&done);
        if (!done)
        {
            MPI_Init(nullptr, nullptr);
            std::atexit(finaliseMPI);
        }
    }
}


void Foam::liggghtsInstance::showWhyItStopped()
{
    if (busyWith.empty() || !Pstream::master())
    {
        return;
    }

    std::deque<std::string> last;
    std::ifstream log(logPath);

    for (std::string line; std::getline(log, line);)
    {
        last.push_back(line);
        if (last.size() > 8)
        {
            last.pop_front();
        }
    }

    std::cerr
        << "\n--> FOAM FATAL ERROR:\nLIGGGHTS stopped the run in: " << busyWith
        << "\nThe last lines of its log " << logPath << ":\n";

    for (const std::string& line : last)
    {
        std::cerr << "    " << line << '\n';
    }

    std::cerr << std::flush;
}


Foam::liggghtsInstance::liggghtsInstance(const fileName& logFile)
:
    lmp_(nullptr)
{
    initialiseMPI();

    static const bool registered = !std::atexit(showWhyItStopped);
    (void)registered;

    logPath = logFile;

    std::string log(logFile);
    char name[] = "liggghts", logFlag[] = "-log", screenFlag[] = "-screen";
    // "none" would be a null pointer that reading a surface prints to
    char none[] = "/dev/null";
    char* args[] = {name, logFlag, &log[0], screenFlag, none};

    const fpeGuard guard;
    const nowDoing now("starting up");

    const quietErrors quiet;

    void* opened = nullptr;
    lammps_open(5, args, MPI_COMM_WORLD, &opened);
    lmp_ = static_cast<LAMMPS_NS::LAMMPS*>(opened);
}


Foam::liggghtsInstance::~liggghtsInstance()
{
    const fpeGuard guard;
    lammps_close(lmp_);
}


void Foam::liggghtsInstance::command(const std::string& line)
{
    const fpeGuard guard;
    const nowDoing now("the command '" + line + "'");
    lammps_command(lmp_, line.c_str());
}


void Foam::liggghtsInstance::script
(
    const fileName& file,
    const fileName& caseFolder
)
{
    const fpeGuard guard;
    const nowDoing now("the script " + file);

    const fileName before(cwd());
    chDir(caseFolder);
    lammps_file(lmp_, file.c_str());
    chDir(before);
}


void Foam::liggghtsInstance::setup()
{
    const fpeGuard guard;
    const nowDoing now("setting up");

    LAMMPS_NS::Update& update = *lmp_->update;

    // The end of the run is not known to LIGGGHTS: we stop it
    update.whichflag = 1;
    update.firststep = update.ntimestep;
    update.beginstep = update.ntimestep;
    update.nsteps = INT_MAX/2;
    update.laststep = update.ntimestep + update.nsteps;
    update.endstep = update.laststep;

    lmp_->init();
    update.integrate->setup();
    lmp_->timer->init();
}


void Foam::liggghtsInstance::run(const label n)
{
    const fpeGuard guard;
    const nowDoing now("the DEM steps");

    lmp_->update->integrate->run(n);
}
