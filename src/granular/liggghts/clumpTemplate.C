// SPDX-License-Identifier: GPL-3.0-or-later
// LIGGGHTS's template of clumps with the exact volume, centre and moments.

#include "clumpTemplate.H"

#include "liggghtsErrors.H"
#include "error.H"
#include "sphereShares.H"

#include <algorithm>

const char* const Foam::clumpTemplate::styleName = "particletemplate/multisphere";


Foam::clumpTemplate::clumpTemplate
(
    LAMMPS_NS::LAMMPS* lmp,
    int narg,
    char** arg
)
:
    LAMMPS_NS::FixTemplateMultisphere(lmp, narg, arg)
{
    liggghtsErrors::runOutside([this]() { checkNoMass(); });
}


void Foam::clumpTemplate::checkNoMass() const
{
    if (mass_set_)
    {
        FatalErrorInFunction
            << "The template of clumps " << id << " has 'mass' and"
            << " 'inertia_tensor'." << nl
            << "    Both follow from its spheres and its density: take them out,"
            << " and 'use_volume' or 'use_density' with them." << exit(FatalError);
    }
}


void Foam::clumpTemplate::setProperties()
{
    pointField centres(nspheres);
    scalarField radii(nspheres);

    forAll(centres, i)
    {
        centres[i] = point(x_sphere[i][0], x_sphere[i][1], x_sphere[i][2]);
        radii[i] = r_sphere[i];
    }

    const sphereUnion all(centres, radii);
    const scalarField shares(sphereShares(centres, radii, all));
    const scalar density = expectancy(pdf_density);
    const symmTensor moi(density*all.inertia());

    volume_expect = all.volume();
    mass_expect = density*volume_expect;
    r_equiv = all.equivalentRadius();

    for (direction k = 0; k < 3; ++k)
    {
        for (direction l = 0; l < 3; ++l)
        {
            moi_[k][l] = tensor(moi)(k, l);
        }

        // The centre of mass is the origin of a template
        forAll(centres, i)
        {
            x_sphere[i][k] -= all.centre()[k];
        }
        x_min[k] -= all.centre()[k];
        x_max[k] -= all.centre()[k];
        x_bound[k] -= all.centre()[k];
    }
    std::copy(shares.cbegin(), shares.cend(), volumeweight_);

    report(all.sphericity());
}


void Foam::clumpTemplate::report(const double sphericity) const
{
    Info<< "    clump " << id << ": " << nspheres << " spheres, volume "
        << volume_expect << " m3, mass " << mass_expect
        << " kg, diameter of the sphere of its volume " << 2*r_equiv
        << " m, sphericity " << sphericity << endl;
}


void Foam::clumpTemplate::post_create()
{
    calc_bounding_sphere();
    liggghtsErrors::runOutside([this]() { setProperties(); });
    check_overlap();
    calc_eigensystem();
    calc_displace_xcm_x_body();
    print_info();
}
