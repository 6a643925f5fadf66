// SPDX-License-Identifier: GPL-3.0-or-later
// Friction that depends on the rate of shear, and dilation towards the solid
// fraction that belongs to it.

#include "dilatantMuI.H"

#include "addToRunTimeSelectionTable.H"
#include "keywords.H"
#include "rootBetween.H"

namespace Foam
{
    defineTypeNameAndDebug(dilatantMuI, 0);
    addToRunTimeSelectionTable(constitutiveLaw, dilatantMuI, dictionary);
}


Foam::dilatantMuI::dilatantMuI(const dictionary& dict)
:
    constitutiveLaw
    (
        checked
        (
            dict,
            {
                "staticFriction", "limitFriction", "b", "maxSolidFraction",
                "looseSolidFraction", "a", "dilation", "contraction", "viscosity",
                "strength"
            }
        )
    ),
    static_(positive(dict, "staticFriction")),
    limit_(positive(dict, "limitFriction")),
    b_(positive(dict, "b")),
    maximum_(positive(dict, "maxSolidFraction")),
    a_(positive(dict, "a")),
    loosest_(dict.getOrDefault<scalar>("looseSolidFraction", maximum_)),
    dilation_(dict.get<scalar>("dilation")),
    contraction_(dict.getOrDefault<scalar>("contraction", 0)),
    diameter_(positive(dict, "grainDiameter")),
    solidDensity_(positive(dict, "solidDensity")),
    viscosity_(dict.getOrDefault<scalar>("viscosity", 0)),
    withDilation_
    (
        keywords::choice
        (
            dict, "strength", "strength", {"printed", "withDilation"}, "printed"
        ) == "withDilation"
    )
{
    if (limit_ < static_)
    {
        FatalIOErrorInFunction(dict)
            << "limitFriction is " << limit_ << ", below staticFriction, "
            << static_ << ": friction rises with the rate of shear."
            << exit(FatalIOError);
    }
    if (!(maximum_ < 1 && dilation_ >= 0 && viscosity_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "maxSolidFraction is " << maximum_ << ", dilation " << dilation_
            << " and viscosity " << viscosity_ << " Pa s; the first lies below"
            << " one, the others not below zero." << exit(FatalIOError);
    }
    checkContraction(dict);
}


void Foam::dilatantMuI::checkContraction(const dictionary& dict) const
{
    if (!(loosest_ > 0 && loosest_ <= maximum_ && contraction_ >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "looseSolidFraction is " << loosest_ << " and contraction "
            << contraction_ << "; the first lies above zero and not above"
            << " maxSolidFraction, " << maximum_ << ", the other not below zero."
            << exit(FatalIOError);
    }
    if ((loosest_ < maximum_) != (contraction_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "contraction is " << contraction_ << " and looseSolidFraction "
            << loosest_ << " of maxSolidFraction " << maximum_ << ". A skeleton"
            << " that is loose bears stress until shear contracts it: set both, or"
            << " neither." << exit(FatalIOError);
    }

    // Else a strain in shear lowers the strength by more than the stress
    const scalar largest =
        shearModulus()/(limit_*bulkModulus()*max(maximum_ - loosest_, SMALL));
    if (contraction_ >= largest)
    {
        FatalIOErrorInFunction(dict)
            << "contraction is " << contraction_ << ", with which the skeleton"
            << " collapses in no time; below " << largest << " it does not, by the"
            << " other numbers of this law." << exit(FatalIOError);
    }
}


Foam::scalar Foam::dilatantMuI::dilatancyOf
(
    const scalar phi,
    const scalar equilibrium
) const
{
    const scalar excess = phi - equilibrium;
    return (excess > 0 ? dilation_ : settling_ ? 0 : contraction_)*excess;
}


Foam::scalar Foam::dilatantMuI::mixedNumber
(
    const scalar rate,
    const scalar p
) const
{
    return sqrt
    (
        (sqr(rate*diameter_)*solidDensity_ + 2*viscosity_*rate)
       /max(p, SMALL)
    );
}


Foam::scalar Foam::dilatantMuI::dilatancy
(
    const scalar rate,
    const scalar p,
    const scalar phi
) const
{
    return dilatancyOf(phi, maximum_/(1 + a_*mixedNumber(rate, p)));
}


Foam::scalar Foam::dilatantMuI::yieldLimit
(
    const scalar rate,
    const scalar p,
    const scalar phi
) const
{
    const scalar I = mixedNumber(rate, p);
    scalar result = static_*p;

    if (I > VSMALL)
    {
        result +=
            (limit_ - static_)*I/(I + b_)*p + 2.5*phi*viscosity_*rate/(a_*I);
    }

    return withDilation_ ? result + dilatancy(rate, p, phi)*p : result;
}


Foam::scalar Foam::dilatantMuI::largestPressure
(
    const scalar rate,
    const scalar phi
) const
{
    return
        sqr(a_*phi/max(maximum_ - phi, SMALL))
       *(sqr(rate*diameter_)*solidDensity_ + 2*viscosity_*rate);
}


Foam::scalar Foam::dilatantMuI::equilibriumNumber(const scalar phi) const
{
    return max(maximum_ - phi, SMALL)/(a_*phi);
}


Foam::dilatantMuI::flow Foam::dilatantMuI::sheared
(
    const state& trial,
    const scalar phi,
    const scalar dt
) const
{
    const scalar K = bulkModulus();
    const scalar G = shearModulus();
    const scalar inertia = sqr(diameter_)*solidDensity_;

    // Of a given I_m friction and dilatancy are numbers, and rate and pressure
    // follow from linear equations; what is left is that they have this I_m.
    // x = I_m/(1 + I_m), so that all of them lie in 0 to 1
    scalar rate = 0;
    scalar p = 0;
    const auto excess = [&](const scalar x)
    {
        const scalar rest = 1 - x;
        const scalar beta = dilatancyOf(phi, maximum_*rest/(rest + a_*x));
        const scalar mu =
            static_ + (limit_ - static_)*x/(x + b_*rest)
          + (withDilation_ ? beta : 0);

        rate = max
        (
            (trial.rootJ2 - mu*trial.p)
           /(
                G*dt + mu*K*dt*beta
              + 2.5*phi*viscosity_*rest/(a_*x)
            ),
            scalar(0)
        );
        p = trial.p + K*dt*rate*beta;

        return
            sqr(x)*p
          - sqr(rest)*(inertia*sqr(rate) + 2*viscosity_*rate);
    };

    // Where I_m is smaller than that at which phi_eq = phi, it compacts. Else it is
    // larger, and there is no contraction, which so far from phi_m would leave no root
    scalar least = SMALL;
    if (phi < loosest_)
    {
        const scalar I = equilibriumNumber(phi);
        if (excess(I/(1 + I)) > 0)
        {
            return compacted(trial, phi, dt);
        }
        if (contraction_ > 0)
        {
            least = I/(1 + I);
        }
    }

    excess(rootBetween(excess, least, scalar(1)));
    return flow{max(p, scalar(0)), rate};
}


Foam::dilatantMuI::flow Foam::dilatantMuI::compacted
(
    const state& trial,
    const scalar phi,
    const scalar dt
) const
{
    // phi_eq = phi gives I_m, and the rest is quadratic in the rate
    const scalar I = equilibriumNumber(phi);
    const scalar mu = static_ + (limit_ - static_)*I/(I + b_);
    const scalar square = mu*sqr(diameter_/I)*solidDensity_;
    const scalar linear =
        shearModulus()*dt
      + (2*mu/I + 2.5*phi/a_)*viscosity_/I;
    const scalar rate =
        2*trial.rootJ2
       /(linear + sqrt(sqr(linear) + 4*square*trial.rootJ2));

    return flow{largestPressure(rate, phi), rate};
}


Foam::dilatantMuI::state Foam::dilatantMuI::returned
(
    const state& trial,
    const scalar phi,
    const scalar dt
) const
{
    const flow after(sheared(trial, phi, dt));
    const scalar rootJ2 = trial.rootJ2 - shearModulus()*dt*after.rate;
    return state{after.p, after.p > 0 ? max(rootJ2, scalar(0)) : 0};
}


void Foam::dilatantMuI::update
(
    pointSet& points,
    const label body,
    const UList<scalar>& dilation,
    const scalar dt
) const
{
    const scalar K = bulkModulus();
    const scalar G = shearModulus();

    for (label i = 0; i < points.size(); ++i)
    {
        if (points.body[i] != body)
        {
            continue;
        }

        const tensor& L = points.gradient[i];
        symmTensor& stress = points.stress[i];
        const symmTensor rate(dev(symm(L)));
        points.strain[i] += dt*sqrt(2.0/3.0*magSqr(rate));

        symmTensor s(dev(stress));
        s += dt*(turning(L, s) + 2*G*rate);
        const state trial
        {
            -tr(stress)/3 - K*dt*dilation[i], sqrt(0.5*magSqr(s))
        };
        const scalar phi = points.mass[i]/points.volume[i]/solidDensity_;

        const bool elastic =
            phi >= loosest_
         && trial.p >= 0
         && trial.rootJ2 <= yieldLimit(0, trial.p, phi);

        const state after(elastic ? trial : returned(trial, phi, dt));

        stress = -after.p*symmTensor::I;
        if (trial.rootJ2 > VSMALL)
        {
            stress += after.rootJ2/trial.rootJ2*s;
        }
    }
}
