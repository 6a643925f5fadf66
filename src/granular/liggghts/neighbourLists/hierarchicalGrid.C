// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the spheres that are near a sphere, among spheres of very different sizes.

#include "hierarchicalGrid.H"

#include "boundsOf.H"

#include <cmath>

namespace
{
    std::array<float, 3> centre(const Foam::packedSpheres::sphere& s)
    {
        return {s.x, s.y, s.z};
    }

    template<class T>
    std::size_t bytesOf(const std::vector<T>& list)
    {
        return list.capacity()*sizeof(T);
    }
}


std::array<int, 2> Foam::hierarchicalGrid::level::range
(
    const int axis,
    const float x,
    const float r
) const
{
    const float below = std::floor((x - r - low[axis])/side);
    const float beyond = std::floor((x + r - low[axis])/side);
    const float last = float(cells[axis] - 1);

    if (!(beyond >= 0 && below <= last))
    {
        return {1, 0};
    }

    return {int(std::max(below, 0.f)), int(std::min(beyond, last))};
}


void Foam::hierarchicalGrid::chooseLevels()
{
    const int n = spheres_.size();
    levelOf_.resize(n);

    if (!n)
    {
        levels_.clear();
        return;
    }

    float least = spheres_[0].radius, most = least;
    for (int i = 1; i < n; ++i)
    {
        least = std::min(least, spheres_[i].radius);
        most = std::max(most, spheres_[i].radius);
    }
    const int first = std::ilogb(least);
    levels_.resize(std::ilogb(most) - first + 1);

    for (level& l : levels_)
    {
        l.largest = 0;
        l.members.clear();
    }

    for (int i = 0; i < n; ++i)
    {
        levelOf_[i] = std::ilogb(spheres_[i].radius) - first;
        level& l = levels_[levelOf_[i]];
        l.largest = std::max(l.largest, spheres_[i].radius);
        l.members.push_back(i);
    }
}


void Foam::hierarchicalGrid::chooseCells()
{
    for (level& l : levels_)
    {
        triple high;
        l.low.fill(std::numeric_limits<float>::max());
        high.fill(std::numeric_limits<float>::lowest());

        for (const int i : l.members)
        {
            const triple x = centre(spheres_[i]);
            for (int d = 0; d < 3; ++d)
            {
                l.low[d] = std::min(l.low[d], x[d]);
                high[d] = std::max(high[d], x[d]);
            }
        }

        const double most = mostCellsPerSphere*double(l.members.size()) + 1;
        l.side = 2*l.largest/float(wideningOfCells);
        double all;
        do
        {
            l.side *= float(wideningOfCells);
            all = 1;
            for (int d = 0; d < 3; ++d)
            {
                const double cells =
                    l.members.empty() ? 0 : std::floor((high[d] - l.low[d])/l.side) + 1;
                l.cells[d] = int(std::min(cells, most));
                all *= cells;
            }
        } while (all > most);
    }
}


void Foam::hierarchicalGrid::fill()
{
    cellOf_.resize(spheres_.size());

    for (level& l : levels_)
    {
        l.start.assign(std::size_t(l.cells[0])*l.cells[1]*l.cells[2] + 1, 0);

        for (const int i : l.members)
        {
            const triple x = centre(spheres_[i]);
            std::array<int, 3> cell;
            for (int d = 0; d < 3; ++d)
            {
                cell[d] = std::min
                (
                    int((x[d] - l.low[d])/l.side),
                    l.cells[d] - 1
                );
            }
            cellOf_[i] = (cell[2]*l.cells[1] + cell[1])*l.cells[0] + cell[0];
            ++l.start[cellOf_[i]];
        }

        // Ends of the cells, which become their starts as spheres come in from the
        // last to the first
        for (std::size_t c = 1; c < l.start.size(); ++c)
        {
            l.start[c] += l.start[c - 1];
        }

        l.id.resize(l.members.size());
        l.spheres.resize(l.members.size());

        for (auto i = l.members.rbegin(); i != l.members.rend(); ++i)
        {
            const int place = --l.start[cellOf_[*i]];
            l.id[place] = *i;
            l.spheres[place] = spheres_[*i];
        }
    }
}


void Foam::hierarchicalGrid::set
(
    const double* x,
    const double* radius,
    const int n
)
{
    spheres_.set(x, radius, n);
    chooseLevels();
    chooseCells();
    fill();
}


Foam::hierarchicalGrid::indices Foam::hierarchicalGrid::overlapsAbove(const int i)
{
    const packedSpheres::sphere s = spheres_[i];
    const triple x = centre(s);
    std::size_t n = 0;

    for (const level& l : levels_)
    {
        if (l.id.empty())
        {
            continue;
        }

        const float reach = s.radius + l.largest;
        const auto xs = l.range(0, x[0], reach);
        const auto ys = l.range(1, x[1], reach);
        const auto zs = l.range(2, x[2], reach);

        for (int cz = zs[0]; cz <= zs[1] && xs[0] <= xs[1]; ++cz)
        {
            for (int cy = ys[0]; cy <= ys[1]; ++cy)
            {
                // Cells along x are one after the other
                const int row = (cz*l.cells[1] + cy)*l.cells[0];
                const int begin = l.start[row + xs[0]];
                const int end = l.start[row + xs[1] + 1];

                if (found_.size() < n + (end - begin))
                {
                    found_.resize(2*(n + end - begin));
                }

                // Noted of each, kept of those that overlap: no branch
                int* const list = found_.data();
                for (int k = begin; k < end; ++k)
                {
                    list[n] = l.id[k];
                    n +=
                        int(packedSpheres::overlap(s, l.spheres[k]))
                      & int(l.id[k] > i);
                }
            }
        }
    }

    return {found_.data(), int(n)};
}


std::size_t Foam::hierarchicalGrid::bytes() const
{
    std::size_t sum =
        spheres_.bytes() + bytesOf(levelOf_) + bytesOf(cellOf_) + bytesOf(found_);

    for (const level& l : levels_)
    {
        sum +=
            bytesOf(l.members) + bytesOf(l.start) + bytesOf(l.spheres)
          + bytesOf(l.id);
    }

    return sum;
}
