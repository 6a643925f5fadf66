// SPDX-License-Identifier: GPL-3.0-or-later
// LIGGGHTS's lists of neighbours, found by size class and with a skin for each grain.

#include "neighbourLists.H"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include <mpi.h>

#include <liggghts/atom.h>
#include <liggghts/comm.h>
#include <liggghts/domain.h>
#include <liggghts/error.h>
#include <liggghts/fix_contact_history.h>
#include <liggghts/force.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/neigh_list.h>
#include <liggghts/neigh_request.h>
#include <liggghts/update.h>

namespace
{
    // Of 8 to 30 steps, 0.01 to 0.04 and 0.4 to 2 diameters these were among the
    // fastest in the moving surge; all are within the scatter of its times, a tenth

        //- Steps for which lists shall last
        constexpr double steps = 12;

        //- Least skin of a grain, over the largest there may be
        constexpr double leastSkin = 0.02;

        //- The skin where none is given, over the smallest diameter
        constexpr double skinOverDiameter = 1;

    //- Bins of LIGGGHTS for each grain, at most
    constexpr double binsPerGrain = 4;

    // What LIGGGHTS has before any command, in SI units
    constexpr int style = 1, delayAtStart = 10;
    constexpr double skinAtStart = 0.001;
}


Foam::neighbourLists& Foam::neighbourLists::replace(LAMMPS_NS::LAMMPS* lmp)
{
    delete lmp->neighbor;
    auto* own = new neighbourLists(lmp);
    lmp->neighbor = own;

    return *own;
}


Foam::neighbourLists::neighbourLists(LAMMPS_NS::LAMMPS* lmp)
:
    LAMMPS_NS::Neighbor(lmp)
{}


bool Foam::neighbourLists::oneSkin() const
{
    return
        boxcheck || atom->radvary_flag || !dist_check || delay > 0 || every > 1
     || build_once || !comm->ghost_velocity;
}


double Foam::neighbourLists::defaultSkin() const
{
    double largest, smallest;
    modify->max_min_rad(largest, smallest);

    return largest > 0 ? skinOverDiameter*2*smallest : skin;
}


void Foam::neighbourLists::chooseSkin()
{
    if (skin == skinAtStart)
    {
        ownSkin_ = skin = defaultSkin();
    }
    if (delay == delayAtStart)
    {
        delay = 0;
    }
}


void Foam::neighbourLists::boundBins()
{
    if (binsizeflag && binsize_user != ownBinSize_)
    {
        return;
    }

    double volume = 1, thinnest = domain->prd[0];
    for (int d = 0; d < 3; ++d)
    {
        volume *= domain->prd[d];
        thinnest = std::min(thinnest, domain->prd[d]);
    }

    // LIGGGHTS takes no bins that are 100 times as wide as the box
    const double bins = binsPerGrain*std::max(1., double(atom->natoms));
    ownBinSize_ =
        std::max(0.5*cutneighmax, std::min(std::cbrt(volume/bins), 50*thinnest));
    binsize_user = ownBinSize_;
    binsizeflag = ownBinSize_ > 0;

    // Those to sort grains by are as many
    if (ownBinSize_ > 0.5*cutneighmax)
    {
        std::ostringstream size;
        size.precision(17);
        size << ownBinSize_;
        std::string words[] = {"sort", std::to_string(atom->sortfreq), size.str()};
        char* arguments[] = {&words[0][0], &words[1][0], &words[2][0]};
        atom->modify_params(3, arguments);
    }
}


void Foam::neighbourLists::init()
{
    if (skin == ownSkin_)
    {
        ownSkin_ = skin = defaultSkin();
    }

    Neighbor::init();
    boundBins();
}


void Foam::neighbourLists::choose_build
(
    int index,
    LAMMPS_NS::NeighRequest* request
)
{
    Neighbor::choose_build(index, request);

    const bool derived = request->copy || request->skip || request->half_from_full;

    if
    (
        request->gran && !derived && !request->half && !request->full
     && !request->omp && Neighbor::style == ::style && !newton_pair && !triclinic
     && !includegroup
    )
    {
        pair_build[index] = static_cast<PairPtr>(&neighbourLists::listGrains);
    }
}


void Foam::neighbourLists::build(int topoflag)
{
    const int n = atom->nlocal + atom->nghost;
    const double* const radius = atom->radius;

    if (!radius || oneSkin())
    {
        skins_.assign(n, 0.5*skin);
    }
    else
    {
        skinFinder_.find
        (
            n ? atom->x[0] : nullptr,
            n ? atom->v[0] : nullptr,
            radius,
            n,
            steps*update->dt,
            leastSkin*skin,
            0.5*skin,
            skins_
        );
    }

    Neighbor::build(topoflag);
}


int Foam::neighbourLists::check_distance()
{
    if (oneSkin())
    {
        return Neighbor::check_distance();
    }

    // Grains are sorted at fixed steps, whenever the lists were built before
    int far = atom->sortfreq > 0 && update->ntimestep % atom->sortfreq == 0;
    for (int i = 0; i < atom->nlocal; ++i)
    {
        double squared = 0;
        for (int d = 0; d < 3; ++d)
        {
            const double moved = atom->x[i][d] - xhold[i][d];
            squared += moved*moved;
        }
        far |= squared > skins_[i]*skins_[i];
    }

    int anyFar;
    MPI_Allreduce(&far, &anyFar, 1, MPI_INT, MPI_MAX, world);

    return anyFar;
}


void Foam::neighbourLists::remember
(
    LAMMPS_NS::NeighList& list,
    const int i,
    const int* near,
    const int n
)
{
    LAMMPS_NS::FixContactHistory& history = *list.fix_history;
    LAMMPS_NS::NeighList& memory = *list.listgranhistory;
    const int size = memory.dnum;
    int* const flags = memory.ipage->vget();
    double* const values = memory.dpage->vget();

    std::fill_n(flags, n, 0);
    std::fill_n(values, n*size, 0.0);

    for (int m = 0; m < history.n_partner(i); ++m)
    {
        for (int k = 0; k < n; ++k)
        {
            const int j = near[k];

            // The image of a partner, too, has its number: that which touches it is
            if (atom->tag[j] != history.partner(i, m))
            {
                continue;
            }

            double squared = 0;
            for (int d = 0; d < 3; ++d)
            {
                const double apart = atom->x[i][d] - atom->x[j][d];
                squared += apart*apart;
            }
            const double touch =
                (atom->radius[i] + atom->radius[j])*contactDistanceFactor;

            if (squared < touch*touch && !flags[k])
            {
                flags[k] = 1;
                std::copy_n(history.contacthistory(i, m), size, values + k*size);
            }
        }
    }

    memory.firstneigh[i] = flags;
    memory.firstdouble[i] = values;
    memory.ipage->vgot(n);
    memory.dpage->vgot(n*size);
}


void Foam::neighbourLists::listGrains(LAMMPS_NS::NeighList* list)
{
    // Meshes and others look into them
    bin_atoms();

    const int nLocal = atom->nlocal;
    const int nAll = nLocal + atom->nghost;

    // A list may be wanted between two builds, with other ghosts
    skins_.resize(nAll, 0.5*skin);
    reaches_.resize(nAll);
    for (int i = 0; i < nAll; ++i)
    {
        reaches_[i] = atom->radius[i]*contactDistanceFactor + skins_[i];
    }
    grid_.set(nAll ? atom->x[0] : nullptr, reaches_.data(), nAll);

    list->ipage->reset();
    if (list->fix_history)
    {
        list->listgranhistory->ipage->reset();
        list->listgranhistory->dpage->reset();
    }

    for (int i = 0; i < nLocal; ++i)
    {
        const hierarchicalGrid::run near = grid_.above(i);

        if (near.size >= oneatom)
        {
            error->one(FLERR, "Neighbor list overflow, boost neigh_modify one");
        }

        int* const neighbours = list->ipage->vget();
        int n = 0;
        for (int k = 0; k < near.size; ++k)
        {
            const int j = near.first[k];
            neighbours[n] = j;
            n += !exclude
             || !exclusion
                (
                    i, j, atom->type[i], atom->type[j], atom->mask, atom->molecule
                );
        }

        // By number, so that sums do not depend on the grid
        std::sort(neighbours, neighbours + n);

        list->ilist[i] = i;
        list->firstneigh[i] = neighbours;
        list->numneigh[i] = n;
        list->ipage->vgot(n);

        if (list->fix_history)
        {
            remember(*list, i, neighbours, n);
        }
    }

    list->inum = nLocal;
}
