// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown where LIGGGHTS ends the program.

#include "liggghtsErrors.H"

#include "Pstream.H"
#include "screenTail.H"

#include <mpi.h>

#include <cstdlib>
#include <iostream>

namespace
{
    // What showWhyItStopped() needs after main() has ended
    std::string logPath;
    std::string busyWith;
    std::string hint;
    const Foam::screenTail* screenLines = nullptr;

    //- What to do about an error of LIGGGHTS that has these words. Beside others: the
    //  hint that there is stays behind it, elsewhere it gives way
    struct remedy
    {
        const char* words;
        std::string whatToDo;
        bool isBesideOthers;
    };

    const remedy remedies[] =
    {
        // It goes on with 'boundary m m m', which is not for this program
        {
            "esh elements have been lost",
            "A surface of the script reaches out of the box of the grains,"
            " at the start or where it moves to:\nenlarge the region that"
            " create_box names (where read_data reads the grains of"
            " preparePacking:\ndomain in system/packingDict).",
            false
        },
        {
            "Cannot open file",
            "There is no such file. One of grains (constant/grains/data) is"
            " written by\npreparePacking: run it before. ",
            true
        },
        {
            "Did not assign all atoms",
            "A grain of the file lies outside of the box in its head (xlo"
            " xhi ...). Both are in metres;\npreparePacking writes the"
            " box that domain in system/packingDict has. ",
            true
        },
        {
            "Could not locate a fix/property",
            "The contact model needs this property: give it by a 'fix ..."
            " property/global' in the script\nof the physics, or choose"
            " another model there.",
            false
        },
        {
            "Length not ",
            "The property has too few values for the materials (atom types)"
            " of the grains: one for each,\nn*n with peratomtypepair. Or a"
            " packing, or materials in system/packingDict, names one too"
            " many.",
            false
        },
        {
            "Too many atom sorting bins",
            "The box of the grains, which holds the mesh, is too large for"
            " grains of their size: mesh and\ngrains must both be in"
            " metres (a mesh in millimetres: transformPoints).",
            false
        },
        {
            "Non-numeric positions",
            "A force on a grain was no number: is the DEM step too long (timestep in"
            " the script of the\nphysics), or do grains overlap at the start?",
            false
        },
        {
            "Neighbor list overflow",
            "A grain has thousands of neighbours. A boulder in sand may have: write"
            " 'neigh_modify one 20000\npage 400000' in the script of the physics. Else"
            " check that diameters and places are both in\nmetres, and the distance"
            " that the command 'neighbor' gives.",
            false
        }
    };

    //- Write what LIGGGHTS was doing and its last words, where it ended the
    //  program
    void showWhyItStopped()
    {
        if (busyWith.empty() || !screenLines)
        {
            return;
        }

        std::cerr
            << "\n--> FOAM FATAL ERROR:\nLIGGGHTS stopped the run in: "
            << busyWith << "\nIts last words (all are in " << logPath << "):\n";

        for (const std::string& line : screenLines->lines())
        {
            std::cerr << "    " << line << '\n';

            for (const remedy& r : remedies)
            {
                if (line.find(r.words) != std::string::npos)
                {
                    hint = r.whatToDo + (r.isBesideOthers ? hint : "");
                }
            }

            // What LIGGGHTS 3.8 adds to an error is read from freed memory
            if (line.compare(0, 5, "ERROR") == 0)
            {
                break;
            }
        }

        std::cerr << hint << '\n' << std::flush;
        busyWith.clear();
    }

    //- LIGGGHTS ends the program by exit() on all ranks, if all met the error
    void showOnce()
    {
        if (Foam::Pstream::master())
        {
            showWhyItStopped();
        }
    }
}


//- LIGGGHTS ends the program by MPI_Abort, if one rank alone met the error. MPI
//  lets a program stand before its functions, under whose own names they start
//  with PMPI
extern "C" int MPI_Abort(MPI_Comm comm, int code)
{
    showWhyItStopped();
    return PMPI_Abort(comm, code);
}


void Foam::liggghtsErrors::open(const screenTail& screen, const fileName& logFile)
{
    static const bool registered = !std::atexit(showOnce);
    (void)registered;

    logPath = logFile;
    screenLines = &screen;
}


void Foam::liggghtsErrors::close()
{
    screenLines = nullptr;
}


void Foam::liggghtsErrors::runOutside(const std::function<void()>& f)
{
    const std::string what(std::move(busyWith));
    busyWith.clear();
    f();
    busyWith = what;
}


Foam::liggghtsErrors::activity::activity
(
    const std::string& name,
    const std::string& whatToDo
)
{
    busyWith = name;
    hint = whatToDo;
}


Foam::liggghtsErrors::activity::~activity()
{
    busyWith.clear();
}


Foam::liggghtsErrors::quietErrors::quietErrors()
:
    shown_(std::cerr.rdbuf(nullptr))
{}


Foam::liggghtsErrors::quietErrors::~quietErrors()
{
    std::cerr.rdbuf(shown_);
}
