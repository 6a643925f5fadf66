// SPDX-License-Identifier: GPL-3.0-or-later
// LIGGGHTS's lists of neighbours, found by size class and with a skin for each grain.

#include "neighbourLists.H"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <string>

#include <mpi.h>

#include <liggghts/atom.h>
#include <liggghts/comm.h>
#include <liggghts/domain.h>
#include <liggghts/error.h>
#include <liggghts/fix_contact_history.h>
#include <liggghts/lammps.h>
#include <liggghts/modify.h>
#include <liggghts/neigh_list.h>
#include <liggghts/neigh_request.h>
#include <liggghts/update.h>

namespace
{
    // Tried in the moving surge: 8 to 30 steps, 0.01 to 0.04 and 0.4 to 2 diameters.
    // All ran as fast within the scatter of their times, a tenth

        //- Steps for which lists shall last
        constexpr double steps = 12;

        //- Least skin of a grain, over the largest there may be
        constexpr double leastSkin = 0.02;

        //- The skin where none is given, over the mean diameter
        constexpr double skinOverDiameter = 1;

    //- Less where a boulder then had more neighbours than LIGGGHTS has room for (2000),
    //  but never below this, over the mean radius
    constexpr double mostNeighbours = 1500, leastSkinOverRadius = 0.2;

    //- Solid fraction of spheres that are as close as they can be
    constexpr double closePacking = 0.74;

    //- Bins of LIGGGHTS for each grain at most, and bins that there may always be
    constexpr double binsPerGrain = 4, binsAnyway = 1e6;

    //- LIGGGHTS's number for the style "bin"
    constexpr int binStyle = 1;
}


void Foam::neighbourLists::replace(LAMMPS_NS::LAMMPS* lmp)
{
    delete lmp->neighbor;
    lmp->neighbor = new neighbourLists(lmp);
}


Foam::neighbourLists::neighbourLists(LAMMPS_NS::LAMMPS* lmp)
:
    LAMMPS_NS::Neighbor(lmp)
{}


bool Foam::neighbourLists::buildsLists() const
{
    return style == binStyle && !newton_pair && !triclinic && !includegroup;
}


bool Foam::neighbourLists::oneSkin() const
{
    return
        !buildsLists() || boxcheck || atom->radvary_flag || !dist_check || delay > 0
     || every > 1 || build_once || !comm->ghost_velocity;
}


double Foam::neighbourLists::meanDiameter(LAMMPS_NS::LAMMPS& lmp)
{
    const LAMMPS_NS::Atom& atom = *lmp.atom;
    double sums[2] =
    {
        atom.radius ? std::accumulate(atom.radius, atom.radius + atom.nlocal, 0.0) : 0,
        double(atom.nlocal)
    };
    MPI_Allreduce(MPI_IN_PLACE, sums, 2, MPI_DOUBLE, MPI_SUM, lmp.world);

    return sums[0] > 0 ? 2*sums[0]/sums[1] : -1;
}


double Foam::neighbourLists::defaultSkin() const
{
    double largest, smallest;
    modify->max_min_rad(largest, smallest);
    if (!(largest > 0))
    {
        return skin;
    }

    // Of grains that will be inserted the sizes alone are known
    const double d = meanDiameter(*lmp);
    const double radius = d > 0 ? 0.5*d : smallest;

    // Small spheres as close as they can be fill the shell around the largest
    const double ratio = largest/radius;
    const double shell =
        std::cbrt(std::pow(ratio, 3) + mostNeighbours/closePacking) - ratio - 2;

    // Two digits, so that the order of a sum over grains does not count
    std::ostringstream digits;
    digits.precision(2);
    digits
        << radius*std::max(leastSkinOverRadius, std::min(2*skinOverDiameter, shell));

    return std::stod(digits.str());
}


void Foam::neighbourLists::chooseSkin()
{
    if (skin == liggghtsSkin)
    {
        chosenSkin_ = skin = defaultSkin();
    }
    if (delay == liggghtsDelay)
    {
        delay = 0;
    }
}


void Foam::neighbourLists::checkPositions() const
{
    double sum = 0;
    for (int i = 0; i < atom->nlocal + atom->nghost; ++i)
    {
        sum += atom->x[i][0] + atom->x[i][1] + atom->x[i][2];
    }

    if (!std::isfinite(sum))
    {
        error->one(FLERR, "Non-numeric positions of grains");
    }
}


void Foam::neighbourLists::boundBins()
{
    if ((binsizeflag && binsize_user != defaultBinSize_) || atom->firstgroupname)
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
    const double most = std::max(binsAnyway, binsPerGrain*double(atom->natoms));
    defaultBinSize_ =
        std::max(0.5*cutneighmax, std::min(std::cbrt(volume/most), 50*thinnest));
    binsize_user = defaultBinSize_;
    binsizeflag = defaultBinSize_ > 0;

    // Those to sort grains by are as many
    if (defaultBinSize_ > 0.5*cutneighmax)
    {
        std::ostringstream size;
        size.precision(17);
        size << defaultBinSize_;
        std::string words[] = {"sort", std::to_string(atom->sortfreq), size.str()};
        char* arguments[] = {&words[0][0], &words[1][0], &words[2][0]};
        atom->modify_params(3, arguments);
    }
}


void Foam::neighbourLists::init()
{
    if (skin == chosenSkin_)
    {
        chosenSkin_ = skin = defaultSkin();
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
     && !request->omp && buildsLists()
    )
    {
        pair_build[index] = static_cast<PairPtr>(&neighbourLists::listGrains);
    }
}


void Foam::neighbourLists::build(int topoflag)
{
    checkPositions();

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

        // How far a ghost may move its owner decides, which has the grains near it
        // that are not here: at most this
        std::fill(skins_.begin() + atom->nlocal, skins_.end(), 0.5*skin);
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


void Foam::neighbourLists::setGrid()
{
    const int nAll = atom->nlocal + atom->nghost;

    // A list may be wanted between two builds, with other ghosts
    skins_.resize(nAll, 0.5*skin);
    reaches_.resize(nAll);
    for (int i = 0; i < nAll; ++i)
    {
        reaches_[i] = atom->radius[i]*contactDistanceFactor + skins_[i];
    }
    grid_.set(nAll ? atom->x[0] : nullptr, reaches_.data(), nAll);
}


void Foam::neighbourLists::listGrains(LAMMPS_NS::NeighList* list)
{
    // Meshes and others need the bins
    bin_atoms();
    setGrid();

    list->ipage->reset();
    if (list->fix_history)
    {
        list->listgranhistory->ipage->reset();
        list->listgranhistory->dpage->reset();
    }

    const int nLocal = atom->nlocal;
    for (int i = 0; i < nLocal; ++i)
    {
        const hierarchicalGrid::indices near = grid_.overlapsAbove(i);
        const auto isExcluded = [&](const int j)
        {
            return exclusion
            (
                i, j, atom->type[i], atom->type[j], atom->mask, atom->molecule
            );
        };
        int* const last = near.first + near.size;
        const int n =
            (exclude ? std::remove_if(near.first, last, isExcluded) : last) - near.first;

        if (n >= oneatom)
        {
            error->one(FLERR, "Neighbor list overflow, boost neigh_modify one");
        }

        int* const neighbours = list->ipage->vget();
        std::copy_n(near.first, n, neighbours);

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
