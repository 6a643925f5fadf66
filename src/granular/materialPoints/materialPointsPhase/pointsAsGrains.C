// SPDX-License-Identifier: GPL-3.0-or-later
// Material points as the grains that others see.

#include "pointsAsGrains.H"

Foam::pointsAsGrains::pointsAsGrains
(
    const wordList& names,
    const dictionary& bodies
)
{
    for (const word& body : names)
    {
        const dictionary& of = bodies.subDict(body);
        const scalar bulk = of.get<scalar>("density");
        const scalar solid = of.getOrDefault<scalar>("solidDensity", bulk);

        if (solid < bulk)
        {
            FatalIOErrorInFunction(of)
                << "solidDensity is " << solid << " kg/m3, less than density,"
                << " which is " << bulk << " with the pores." << nl
                << "    Give that of the solid alone, as 2650 for sand."
                << exit(FatalIOError);
        }
        density_.append(solid);
    }
}


Foam::scalar Foam::pointsAsGrains::coarseGraining
(
    const materialPointMethod& method,
    const dictionary& dict,
    const bool given
) const
{
    const label perCell = dict.getOrDefault<label>("pointsPerCell", 2);
    const scalar volume =
        method.grid().cubeVolume(method.grid().h()/perCell);
    scalar ratio = 0;

    forAll(method.bodies(), i)
    {
        const dictionary& body =
            dict.subDict("bodies").subDict(method.bodies()[i]);
        const word key =
            body.found("poreDiameter") ? "poreDiameter" : "grainDiameter";
        if (!body.found(key))
        {
            continue;
        }

        const scalar grain = body.get<scalar>(key);
        const scalar point =
            cbrt(6/M_PI*volume*body.get<scalar>("density")/density_[i]);

        if (!(grain > 0))
        {
            FatalIOErrorInFunction(body)
                << key << " is " << grain << " m; it must be above zero."
                << exit(FatalIOError);
        }
        if (ratio > 0 && mag(point/grain - ratio) > 1e-3*ratio)
        {
            FatalIOErrorInFunction(body)
                << "A point stands for grains of " << grain << " m, "
                << point/grain << " times as large as they are, and in another"
                << " body " << ratio << " times: all bodies have one ratio."
                << nl << "    Give each a " << key << " of "
                << point/ratio << " m."
                << exit(FatalIOError);
        }
        if (given)
        {
            FatalIOErrorInFunction(body)
                << "coarseGraining follows from " << key << ": "
                << point/grain << "." << nl
                << "    Remove coarseGraining, or " << key << "."
                << exit(FatalIOError);
        }
        ratio = point/grain;
    }

    return ratio;
}


void Foam::pointsAsGrains::refresh
(
    const pointSet& p,
    const scalar interval
)
{
    halfCurl.setSize(p.size());
    radius.setSize(p.size());
    meanForce.setSize(p.size());
    noTorque.setSize(p.size(), Zero);

    forAll(p.x, i)
    {
        const tensor& L = p.gradient[i];
        halfCurl[i] = 0.5*vector
        (
            L.zy() - L.yz(), L.xz() - L.zx(), L.yx() - L.xy()
        );
        radius[i] = cbrt
        (
            0.75/M_PI*p.mass[i]/density_[p.body[i]]
        );
        meanForce[i] = p.mass[i]/interval*(p.U[i] - p.before[i]);
    }
}
