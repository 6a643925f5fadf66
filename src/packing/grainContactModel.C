// SPDX-License-Identifier: GPL-3.0-or-later
// How grains touch while a bed settles: Hertz contacts with friction.

#include "grainContactModel.H"

#include "keywords.H"
#include "liggghtsInstance.H"
#include "liggghtsChecks.H"

const char* const Foam::grainContactModel::model =
    "model hertz tangential history rolling_friction epsd2";


Foam::grainContactModel::grainContactModel(const dictionary& dict)
:
    dict_(dict.subDict("contact"))
{
    keywords::check
    (
        dict_,
        {
            "youngsModulus", "poissonsRatio", "restitution", "friction",
            "rollingFriction"
        }
    );
    value("youngsModulus", 1e4, 1e12);
    value("poissonsRatio", 0, 0.5);
    value("restitution", 0.05, 1);
    value("friction", 0, 10);
    value("rollingFriction", 0, 10);
}


Foam::scalar Foam::grainContactModel::value
(
    const word& key,
    const scalar low,
    const scalar high
) const
{
    const scalar v = dict_.get<scalar>(key);
    if (v < low || v > high)
    {
        FatalIOErrorInFunction(dict_)
            << key << " is " << v << ", but must be between " << low
            << " and " << high << exit(FatalIOError);
    }
    return v;
}


void Foam::grainContactModel::apply(liggghtsInstance& liggghts) const
{
    const auto property =
        [&](const char* name, const char* kind, const char* key)
        {
            liggghts.command
            (
                std::string("fix ") + name + " all property/global " + name
              + " " + kind + " " + Foam::name(dict_.get<scalar>(key))
            );
        };

    // LIGGGHTS otherwise refuses moduli outside 5 MPa to 1 GPa
    liggghts.command("soft_particles yes");
    liggghts.command("hard_particles yes");

    property("youngsModulus", "peratomtype", "youngsModulus");
    property("poissonsRatio", "peratomtype", "poissonsRatio");
    property("coefficientRestitution", "peratomtypepair 1", "restitution");
    property("coefficientFriction", "peratomtypepair 1", "friction");
    property
    (
        "coefficientRollingFriction", "peratomtypepair 1", "rollingFriction"
    );

    liggghts.vectoriseContacts();
    liggghts.command(std::string("pair_style gran ") + model);
    liggghts.command("pair_coeff * *");
}


Foam::scalar Foam::grainContactModel::timeStep
(
    const scalar diameter,
    const scalar density
) const
{
    const scalar sixth = liggghtsChecks::rayleighTime
    (
        0.5*diameter,
        density,
        dict_.get<scalar>("youngsModulus"),
        dict_.get<scalar>("poissonsRatio")
    )/6;

    const scalar figure = std::pow(10.0, std::floor(std::log10(sixth)) - 1);
    return figure*std::floor(sixth/figure);
}
