// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of the grains of a packing that are clumps of spheres.

#include "clumpShape.H"

#include "Tuple2.H"
#include "sphereUnion.H"

#include <cmath>
#include <ostream>

namespace
{

using namespace Foam;

const char* const names = "cube8, tetra4, rod3 and cobble";


//- Corners of a cube of edge 2, or every second one: a tetrahedron
pointField corners(const bool all)
{
    DynamicList<point> result;
    for (label i = 0; i < 8; ++i)
    {
        const label x = i & 1, y = (i >> 1) & 1, z = i >> 2;
        if (all || (x + y + z) % 2 == 0)
        {
            result.append(point(2*x - 1, 2*y - 1, 2*z - 1));
        }
    }
    return pointField(std::move(result));
}

} // End anonymous namespace


Foam::clumpShape::clumpShape(const dictionary& dict, const scalar diameter)
:
    name_(dict.get<word>("clump")),
    centres_(),
    radii_(),
    diameter_(diameter),
    gyration_(0),
    sphericity_(0)
{
    if (dict.found("spheres") != (name_ == "cobble"))
    {
        FatalIOErrorInFunction(dict)
            << "spheres is the list of a clump cobble, and of no other." << nl
            << "    Write for instance: clump cobble; spheres (((0 0 0) 1)"
            << " ((1 0 0) 0.8)); with centre and radius of each in any unit."
            << exit(FatalIOError);
    }
    read(dict);
    if (centres_.size() < 2 || min(radii_) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "A clump has two spheres at least, each with a radius above zero;"
            << " spheres has " << centres_.size() << ", the smallest radius is "
            << (radii_.size() ? min(radii_) : scalar(0)) << nl
            << "    For single spheres leave clump and spheres out."
            << exit(FatalIOError);
    }
    scale();
}


void Foam::clumpShape::read(const dictionary& dict)
{
    // Edge 4, radius 3: no opening is left between the spheres
    if (name_ == "cube8")
    {
        centres_ = 2.0*corners(true);
        radii_ = scalarField(8, 3.0);
    }
    else if (name_ == "tetra4")
    {
        centres_ = std::sqrt(2.0)*corners(false);
        radii_ = scalarField(4, 3.0);
    }
    else if (name_ == "rod3")
    {
        centres_ = pointField({point(-5, 0, 0), point(0, 0, 0), point(5, 0, 0)});
        radii_ = scalarField(3, 4.0);
    }
    else if (name_ == "cobble")
    {
        for (const auto& s : dict.get<List<Tuple2<point, scalar>>>("spheres"))
        {
            centres_.append(s.first());
            radii_.append(s.second());
        }
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "Unknown clump " << name_ << "; valid are " << names
            << exit(FatalIOError);
    }
}


void Foam::clumpShape::scale()
{
    const sphereUnion all(centres_, radii_);
    const scalar factor = 0.5*diameter_/all.equivalentRadius();

    centres_ = factor*(centres_ - all.centre());
    radii_ *= factor;
    gyration_ = factor*std::sqrt(tr(all.inertia())/(3*all.volume()));
    sphericity_ = all.sphericity();
}


Foam::pointField Foam::clumpShape::placed
(
    const UList<point>& places,
    const UList<quaternion>& orientations
) const
{
    pointField result(places.size()*size());
    forAll(places, i)
    {
        const tensor R(orientations[i].R());
        for (label k = 0; k < size(); ++k)
        {
            result[i*size() + k] = places[i] + (R & centres_[k]);
        }
    }
    return result;
}


Foam::scalarField Foam::clumpShape::diameters(const label n) const
{
    scalarField result(n*size());
    forAll(result, i)
    {
        result[i] = 2*radii_[i % size()];
    }
    return result;
}


void Foam::clumpShape::writeTemplate
(
    std::ostream& os,
    const std::string& name,
    const label material,
    const scalar density,
    const label number
) const
{
    // A seed and a number of points that have no effect here
    os  << "fix " << name << " all particletemplate/multisphere 15485863 atom_type "
        << material << " density constant " << density << " nspheres " << size()
        << " ntry 100000 spheres";

    forAll(centres_, i)
    {
        const point& c = centres_[i];
        os  << " &\n    " << c.x() << ' ' << c.y() << ' ' << c.z() << ' '
            << radii_[i];
    }
    os  << " &\n    type " << number << '\n';
}
