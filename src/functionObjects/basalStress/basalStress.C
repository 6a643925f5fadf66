// SPDX-License-Identifier: GPL-3.0-or-later
// Normal and shear stress on walls, by grains and by the fluid.

#include "basalStress.H"

#include "addToRunTimeSelectionTable.H"
#include "flumeSettings.H"
#include "keywords.H"
#include "wallShear.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(basalStress, 0);
    addToRunTimeSelectionTable(functionObject, basalStress, dictionary);
}
}


namespace
{

//- Sum over all ranks
void reduceAll(std::array<Foam::strips, 3>& sums)
{
    for (Foam::strips& s : sums)
    {
        s.reduce();
    }
}


Foam::vector at(const std::array<Foam::strips, 3>& v, const Foam::label i)
{
    return Foam::vector(v[0].values()[i], v[1].values()[i], v[2].values()[i]);
}

} // End anonymous namespace


Foam::functionObjects::basalStress::basalStress
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    flumeFunctionObject(name, runTime, dict, typeName)
{
    read(dict);

    if (writes())
    {
        writeColumns
        (
            file(),
            "Stress on the wall in Pa, a line for each bin. sigma: normal,"
            " pressing on the wall positive; tau: shear along the direction of"
            " the bins. x in m, area in m2",
            {
                "x", "area", "sigmaGrains", "tauGrains", "p", "tauFluid",
                "sigma", "tau"
            }
        );
    }
}


bool Foam::functionObjects::basalStress::read(const dictionary& dict)
{
    flumeFunctionObject::read(dict);
    checkKeys
    (
        dict,
        {
            "patches", "direction", "binWidth", "p", "U"
        }
    );

    patches_ = flumeSettings::patches(dict, mesh_);
    direction_ =
        keywords::unitVector(dict, "direction", frame_.downslope());
    binWidth_ = dict.getOrDefault<scalar>("binWidth", 0.1);
    pName_ = dict.getOrDefault<word>("p", "p");
    UName_ = dict.getOrDefault<word>("U", "U");

    if (binWidth_ <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "binWidth is " << binWidth_ << " m: it must be above zero."
            << exit(FatalIOError);
    }

    start_ = GREAT;
    end_ = -GREAT;

    for (const label patchi : patches_)
    {
        for (const point& p : mesh_.boundaryMesh()[patchi].localPoints())
        {
            start_ = min(start_, p & direction_);
            end_ = max(end_, p & direction_);
        }
    }

    reduce(start_, minOp<scalar>());
    reduce(end_, maxOp<scalar>());

    // A wall across the direction is one bin
    end_ = max(end_, start_ + 1e-3*binWidth_);

    return true;
}


Foam::functionObjects::basalStress::bins
Foam::functionObjects::basalStress::emptyBins() const
{
    const strips empty(start_, end_, binWidth_);
    return {{empty, empty, empty}};
}


void Foam::functionObjects::basalStress::addFace
(
    bins& to,
    const polyPatch& patch,
    const label face,
    const vector& v
) const
{
    scalar low = GREAT;
    scalar high = -GREAT;

    for (const label pointi : patch[face])
    {
        const scalar s = patch.points()[pointi] & direction_;
        low = min(low, s);
        high = max(high, s);
    }

    for (direction d = 0; d < 3; ++d)
    {
        to[d].addRange(low, high, v[d]);
    }
}


Foam::functionObjects::basalStress::bins
Foam::functionObjects::basalStress::area() const
{
    bins result(emptyBins());

    for (const label patchi : patches_)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];

        forAll(patch, face)
        {
            addFace(result, patch.patch(), face, patch.Sf()[face]);
        }
    }

    reduceAll(result);
    return result;
}


Foam::functionObjects::basalStress::bins
Foam::functionObjects::basalStress::grainForce() const
{
    bins result(emptyBins());
    const grainSnapshot& all = grains();

    const auto addToBin = [&](const label i, const vector& force)
    {
        // A grain touches a bit beyond the wall's end too
        const scalar s = max
        (
            min
            (
                all.position[i] & direction_,
                result[0].end() - 1e-6*binWidth_
            ),
            start_
        );

        for (direction d = 0; d < 3; ++d)
        {
            result[d].add(s, -force[d]);
        }
    };

    for (const label patchi : patches_)
    {
        forEachWallForce(all, mesh_.boundary()[patchi].name(), addToBin);
    }

    reduceAll(result);
    return result;
}


void Foam::functionObjects::basalStress::fluidForce
(
    bins& pressure,
    bins& viscous
) const
{
    if (!fluid_)
    {
        return;
    }

    const tmp<volScalarField> p(field<volScalarField>(pName_));
    const tmp<volVectorField> U(field<volVectorField>(UName_));
    const tmp<volScalarField> alpha(field<volScalarField>(alphaName_));
    const tmp<volScalarField> epsilon(voidFraction());

    tmp<volScalarField> nut;
    if (hasField<volScalarField>("nut"))
    {
        nut = field<volScalarField>("nut");
    }

    for (const label patchi : patches_)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const fluidOnPatch force
        (
            p(),
            U(),
            alpha(),
            epsilon(),
            nut.valid() ? &nut() : nullptr,
            patchi
        );

        forAll(patch, face)
        {
            addFace
            (
                pressure, patch.patch(), face, force.pressure[face]
            );
            addFace
            (
                viscous, patch.patch(), face, force.viscous[face]
            );
        }
    }

    reduceAll(pressure);
    reduceAll(viscous);
}


Foam::List<Foam::scalarList>
Foam::functionObjects::basalStress::stresses() const
{
    const bins S(area());
    const bins fromGrains(grainForce());
    bins pressure(emptyBins());
    bins viscous(emptyBins());
    fluidForce(pressure, viscous);

    DynamicList<scalarList> lines;

    for (label i = 0; i < S[0].size(); ++i)
    {
        const scalar A = mag(at(S, i));

        if (A < SMALL)
        {
            continue;
        }

        const vector n(at(S, i)/A);
        const vector t(direction_ - (direction_ & n)*n);
        const vector along(t/max(mag(t), SMALL));

        const scalar sigmaGrains = (at(fromGrains, i) & n)/A;
        const scalar tauGrains = (at(fromGrains, i) & along)/A;
        const scalar p = (at(pressure, i) & n)/A;
        const scalar tauFluid = (at(viscous, i) & along)/A;

        lines.append
        (
            scalarList
            ({
                S[0].centre(i), A, sigmaGrains, tauGrains, p, tauFluid,
                sigmaGrains + p, tauGrains + tauFluid
            })
        );
    }

    return List<scalarList>(std::move(lines));
}


void Foam::functionObjects::basalStress::report()
{
    if (passOver({pName_, alphaName_, voidFractionName_}))
    {
        return;
    }

    const List<scalarList> lines(stresses());

    if (writes())
    {
        for (const scalarList& line : lines)
        {
            writeLine(file(), line);
        }
    }
}
