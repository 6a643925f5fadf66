// SPDX-License-Identifier: GPL-3.0-or-later
// One LIGGGHTS inside this program: opens it, gives it commands, closes it.

#include "liggghtsInstance.H"

#include "OSspecific.H"
#include "Pstream.H"
#include "fpeGuard.H"
#include "liggghtsErrors.H"
#include "neighbourLists.H"
#include "vectorisedContacts.H"
#include "vectorisedWall.H"

#include <mpi.h>

#include <climits>
#include <cstring>
#include <sstream>

#include <liggghts/atom.h>
#include <liggghts/domain.h>
#include <liggghts/force.h>
#include <liggghts/lammps.h>
#include <liggghts/library.h>
#include <liggghts/integrate.h>
#include <liggghts/modify.h>
#include <liggghts/neighbor.h>
#include <liggghts/timer.h>
#include <liggghts/universe.h>
#include <liggghts/update.h>

namespace
{
    //- More memory than this for bins alone is a mistake in the size of the grains
    //  or of their box [GB]
    constexpr Foam::scalar mostGigabytesOfBins = 2;

    //- Skin of LIGGGHTS's own lists over the mean diameter. Of 0.2 to 0.6, 0.4 ran
    //  fastest while the surge moves
    constexpr Foam::scalar stockSkinOverDiameter = 0.4;
}


Foam::liggghtsInstance::liggghtsInstance(const fileName& logFile)
:
    lmp_(nullptr),
    sortEveryWithGrains_(0)
{
    // A serial OpenFOAM run starts no MPI, and LIGGGHTS needs it
    UPstream::initNull();

    liggghtsErrors::open(screenTail_, logFile);

    std::string log(logFile);
    char name[] = "liggghts", logFlag[] = "-log", screenFlag[] = "-screen";
    // "none" would be a null pointer that reading a surface prints to
    char none[] = "/dev/null";
    char* args[] = {name, logFlag, &log[0], screenFlag, none};

    const fpeGuard guard;
    const liggghtsErrors::activity now("starting up");

    const liggghtsErrors::quietErrors quiet;

    void* opened = nullptr;
    lammps_open(5, args, MPI_COMM_WORLD, &opened);
    lmp_ = static_cast<LAMMPS_NS::LAMMPS*>(opened);

    // On every rank, in place of the file opened on the first
    if (lmp_->screen)
    {
        std::fclose(lmp_->screen);
    }
    lmp_->screen = lmp_->universe->uscreen = screenTail_.screen();
    lammps_command(lmp_, const_cast<char*>("echo both"));
}


Foam::liggghtsInstance::~liggghtsInstance()
{
    const fpeGuard guard;
    lammps_close(lmp_);
    liggghtsErrors::close();
}


bool Foam::liggghtsInstance::isKnown() const
{
    return std::strstr(lmp_->universe->version, "LIGGGHTS-PUBLIC 3.8");
}


bool Foam::liggghtsInstance::vectoriseContacts()
{
    if (!isKnown())
    {
        return false;
    }

    vectorisedContacts::addStyle(lmp_);
    vectorisedWall::addStyle(lmp_);
    return true;
}


Foam::label Foam::liggghtsInstance::nVectorisedWalls() const
{
    const LAMMPS_NS::Modify& modify = *lmp_->modify;
    label n = 0;

    for (label i = 0; i < modify.nfix; ++i)
    {
        const auto* wall = dynamic_cast<const vectorisedWall*>(modify.fix[i]);
        n += wall && wall->isKnown();
    }

    return n;
}


bool Foam::liggghtsInstance::useNeighbourLists()
{
    if (!isKnown())
    {
        return false;
    }

    neighbourLists::replace(lmp_);
    return true;
}


Foam::neighbourLists* Foam::liggghtsInstance::lists() const
{
    return dynamic_cast<neighbourLists*>(lmp_->neighbor);
}


void Foam::liggghtsInstance::chooseSkin()
{
    if (lists())
    {
        return lists()->chooseSkin();
    }

    const double d = neighbourLists::meanDiameter(*lmp_);
    const LAMMPS_NS::Neighbor& lists = *lmp_->neighbor;
    // 1 is bin
    if (d > 0 && lists.style == 1 && lists.skin == neighbourLists::liggghtsSkin)
    {
        std::ostringstream line;
        line<< "neighbor " << stockSkinOverDiameter*d << " bin";
        command(line.str());
    }
    if (lists.delay == neighbourLists::liggghtsDelay)
    {
        command("neigh_modify delay 0");
    }
}


std::string Foam::liggghtsInstance::whyContactsAreStock() const
{
    auto* contacts = dynamic_cast<vectorisedContacts*>(lmp_->force->pair);

    return contacts ? contacts->reason() : "the case requests it";
}


void Foam::liggghtsInstance::command(const std::string& line)
{
    const fpeGuard guard;
    const liggghtsErrors::activity now("the command '" + line + "'");
    lammps_command(lmp_, line.c_str());
}


void Foam::liggghtsInstance::script
(
    const fileName& file,
    const fileName& caseFolder
)
{
    const fpeGuard guard;
    const liggghtsErrors::activity now
    (
        "the script " + file,
        "Correct the last command above in that script."
    );

    // Also after an error, which a test survives
    const struct returning
    {
        const fileName before = cwd();

        ~returning()
        {
            chDir(before);
        }
    } atEnd;

    chDir(caseFolder);
    lammps_file(lmp_, file.c_str());
}


void Foam::liggghtsInstance::setup()
{
    const fpeGuard guard;
    const liggghtsErrors::activity now("setting up");

    LAMMPS_NS::Update& update = *lmp_->update;

    // The end of the run is not known to LIGGGHTS: we stop it
    update.whichflag = 1;
    update.firststep = update.ntimestep;
    update.beginstep = update.ntimestep;
    update.nsteps = INT_MAX/2;
    update.laststep = update.ntimestep + update.nsteps;
    update.endstep = update.laststep;

    lmp_->init();
    liggghtsErrors::runOutside([this]() { checkBins(); });

    // Without a grain nothing has a size, and there are no bins to sort grains into
    // until a setup finds one
    int& sortEvery = lmp_->atom->sortfreq;
    if (lmp_->neighbor->cutneighmax == 0)
    {
        sortEveryWithGrains_ = max(sortEveryWithGrains_, label(sortEvery));
        sortEvery = 0;
    }
    else if (sortEvery == 0)
    {
        sortEvery = sortEveryWithGrains_;
    }
    setupUnsorted();

    lmp_->timer->init();
}


void Foam::liggghtsInstance::setupUnsorted()
{
    LAMMPS_NS::Atom& atom = *lmp_->atom;
    const bigint step = lmp_->update->ntimestep;
    const int every = atom.sortfreq;

    if (!lists() || step == 0 || every == 0)
    {
        return lmp_->update->integrate->setup();
    }

    atom.sortfreq = 0;
    lmp_->update->integrate->setup();
    atom.sortfreq = every;

    // The bins for it, and the next of the fixed steps
    atom.setup();
    atom.nextsort = (step/every + 1)*every;
}


void Foam::liggghtsInstance::checkBins() const
{
    // Those of neighbourLists are bounded. 0, 1, 2 are nsq, bin, multi
    if (lists() || lmp_->neighbor->style != 1)
    {
        return;
    }

    const LAMMPS_NS::Domain& domain = *lmp_->domain;
    const scalar side = 0.5*lmp_->neighbor->cutneighmax;
    scalar nBins = side > 0 ? 1 : 0;
    vector box;

    for (direction k = 0; k < 3; ++k)
    {
        box[k] = domain.boxhi[k] - domain.boxlo[k];
        nBins *= std::ceil(box[k]/max(side, VSMALL));
    }

    // Two lists have an integer for each: bins of neighbours and bins of sorting
    const scalar gigabytes = 2*sizeof(int)*nBins/1e9/Pstream::nProcs();

    if (gigabytes > mostGigabytesOfBins)
    {
        FatalErrorInFunction
            << "The grains' box of " << box.x() << " x " << box.y() << " x "
            << box.z() << " m takes " << nBins << " bins of " << side
            << " m to find neighbours in: " << gigabytes << " GB of memory on each"
            << " rank." << nl
            << "    With contacts vectorised, the default, there are no more than 4 for a"
            << " grain, or a million. Else make the box (region of create_box) smaller,"
            << " or take more ranks. A bin's side is half of the largest" << nl
            << "    diameter and the distance that the command 'neighbor' gives: with"
            << " few grains, 'neighbor "
            << 2*side*std::cbrt(gigabytes/mostGigabytesOfBins)
            << " bin' helps as well." << exit(FatalError);
    }
}


void Foam::liggghtsInstance::run(const label n)
{
    const fpeGuard guard;
    const liggghtsErrors::activity now("the DEM steps");

    lmp_->update->integrate->run(n);
}
