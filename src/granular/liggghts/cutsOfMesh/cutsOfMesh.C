// SPDX-License-Identifier: GPL-3.0-or-later
// LIGGGHTS's ranks in the places where the mesh is cut.

#include "cutsOfMesh.H"

#include "PstreamReduceOps.H"

#include <algorithm>

#include <liggghts/domain.h>
#include <liggghts/lammps.h>

Foam::cutsOfMesh::planes Foam::cutsOfMesh::between
(
    const polyMesh& mesh,
    const labelVector& n
)
{
    const boundBox own(mesh.points(), false);
    const label rank = Pstream::myProcNo();
    const label place[3] = {rank % n.x(), rank/n.x() % n.y(), rank/(n.x()*n.y())};
    planes result;

    for (direction d = 0; d < 3; ++d)
    {
        scalarList ends(n[d], -GREAT);
        scalarList begins(n[d], GREAT);
        ends[place[d]] = own.max()[d];
        begins[place[d]] = own.min()[d];
        Pstream::listCombineGather(ends, maxEqOp<scalar>());
        Pstream::listCombineScatter(ends);
        Pstream::listCombineGather(begins, minEqOp<scalar>());
        Pstream::listCombineScatter(begins);

        for (label i = 1; i < n[d]; ++i)
        {
            result[d].push_back(0.5*(ends[i - 1] + begins[i]));
        }
    }

    return result;
}


void Foam::cutsOfMesh::replace(LAMMPS_NS::LAMMPS* lmp, const planes& where)
{
    delete lmp->comm;
    lmp->comm = new cutsOfMesh(lmp, where);
}


Foam::cutsOfMesh::cutsOfMesh(LAMMPS_NS::LAMMPS* lmp, const planes& where)
:
    LAMMPS_NS::Comm(lmp),
    planes_(where)
{}


bool Foam::cutsOfMesh::split(const int direction, double* parts) const
{
    const std::vector<double>& cuts = planes_[direction];
    std::vector<double> all(1, 0.0);

    for (const double x : cuts)
    {
        const double part = (x - domain->boxlo[direction])/domain->prd[direction];
        if (part <= all.back() || part >= 1)
        {
            return false;
        }
        all.push_back(part);
    }

    std::copy(all.begin(), all.end(), parts);
    return true;
}


void Foam::cutsOfMesh::set_proc_grid(int outflag)
{
    Comm::set_proc_grid(outflag);

    double* const parts[3] = {xsplit, ysplit, zsplit};
    for (int d = 0; d < 3; ++d)
    {
        if (int(planes_[d].size()) == procgrid[d] - 1 && procgrid[d] > 1)
        {
            uniform = split(d, parts[d]) ? 0 : uniform;
        }
    }
}
