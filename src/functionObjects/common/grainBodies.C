// SPDX-License-Identifier: GPL-3.0-or-later
// The grains with each clump of spheres as one.

#include "grainBodies.H"

#include "swapLists.H"

#include <algorithm>
#include <map>
#include <vector>

namespace
{

using namespace Foam;

//- A sphere, or a grain alone, as it is sent
struct sphere
{
    label id;
    label type;
    label clump;
    scalar share;
    point position;
    vector U;
    vector omega;
    scalar d;
    scalar mass;
    vector force;
    vector contactForce;
    symmTensor stressMoment;
};


sphere sphereOf(const grainSnapshot& from, const label i)
{
    return sphere
    {
        from.id[i], from.type[i], from.clump[i], from.partOfBody(i), from.position[i],
        from.U[i], from.omega[i], from.bodyDiameter(i), from.mass[i], from.force[i],
        from.contactForce[i], from.stressMoment[i]
    };
}


void set(grainSnapshot& grains, const label i, const sphere& body)
{
    grains.id[i] = body.id;
    grains.type[i] = body.type;
    grains.position[i] = body.position;
    grains.U[i] = body.U;
    grains.omega[i] = body.omega;
    grains.d[i] = body.d;
    grains.mass[i] = body.mass;
    grains.force[i] = body.force;
    grains.contactForce[i] = body.contactForce;
    grains.stressMoment[i] = body.stressMoment;
}


//- The clump of these spheres, of which one may lie beyond a side that repeats
sphere wholeOf(std::vector<sphere>& spheres, const periodicity& images)
{
    std::sort
    (
        spheres.begin(), spheres.end(),
        [](const sphere& a, const sphere& b) { return a.id < b.id; }
    );

    sphere whole(spheres.front());
    const point first(whole.position);
    whole.U *= whole.share;

    for (std::size_t k = 1; k < spheres.size(); ++k)
    {
        const sphere& s = spheres[k];
        whole.position += s.share*images.shortest(s.position - first);
        whole.U += s.share*s.U;
        whole.mass += s.mass;
        whole.force += s.force;
        whole.contactForce += s.contactForce;
        whole.stressMoment += s.stressMoment;
    }
    whole.position = images.wrap(whole.position);

    return whole;
}

} // End anonymous namespace


Foam::autoPtr<Foam::grainSnapshot> Foam::grainBodies
(
    const grainSnapshot& spheres,
    const periodicity& images
)
{
    DynamicList<sphere> bodies;
    List<DynamicList<sphere>> toMeet(Pstream::nProcs());

    forAll(spheres.id, i)
    {
        const sphere s(sphereOf(spheres, i));
        (s.clump ? toMeet[s.clump % Pstream::nProcs()] : bodies).append(s);
    }

    std::map<label, std::vector<sphere>> clumps;
    for (const List<sphere>& some : swapLists(toMeet))
    {
        for (const sphere& s : some)
        {
            clumps[s.clump].push_back(s);
        }
    }
    for (auto& clump : clumps)
    {
        bodies.append(wholeOf(clump.second, images));
    }

    auto result = autoPtr<grainSnapshot>::New(bodies.size());
    forAll(bodies, i)
    {
        set(*result, i, bodies[i]);
    }

    return result;
}
