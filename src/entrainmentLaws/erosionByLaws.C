// SPDX-License-Identifier: GPL-3.0-or-later
// Depth of erosion over time by each law, from what was measured at a section.

#include "erosionByLaws.H"

#include "DynamicList.H"
#include "scalarField.H"

Foam::erosionByLaws::erosionByLaws(const dictionary& dict)
:
    scouring_
    (
        dict.subDict("scouring"),
        dict.get<scalar>("slope"),
        dict.getOrDefault<scalar>("gravity", 9.81)
    ),
    laws_
    (
        dict,
        dict.get<scalar>("slope"),
        dict.getOrDefault<scalar>("gravity", 9.81)
    ),
    floor_(dict.getOrDefault<scalar>("erodibleDepth", GREAT))
{}


Foam::scalar Foam::erosionByLaws::meanSquare
(
    const scalarList& a,
    const scalarList& b
)
{
    scalar sum = 0;
    forAll(a, i)
    {
        sum += sqr(a[i] - b[i]);
    }
    return a.size() ? sum/a.size() : 0;
}


Foam::scalar Foam::erosionByLaws::deeper
(
    const scalar depth,
    const scalar more
) const
{
    return min(depth + max(more, scalar(0)), floor_);
}


void Foam::erosionByLaws::checkSigns(const sectionSeries& s)
{
    const label n = s.t.size();

    if (n && average(s.sigma) < 0)
    {
        FatalErrorInFunction
            << "The normal stress pulls in the mean from " << s.t.first() << " to "
            << s.t.last() << " s: it goes from " << min(s.sigma) << " to "
            << max(s.sigma) << " Pa." << nl
            << "    Pressing has to be positive. Stresses of grainStress are positive in"
            << " tension: write factor -1 at normalStress." << exit(FatalError);
    }
    // What stands still may swing around zero
    if (n && max(s.v) <= 0 && min(s.v) < -1e-6)
    {
        FatalErrorInFunction
            << "The velocity is never positive from " << s.t.first() << " to "
            << s.t.last() << " s: it goes from " << min(s.v) << " to "
            << max(s.v) << " m/s, and by the dynamic law such a flow erodes"
            << " nothing." << nl
            << "    The velocity of the flow has to be positive: if it was measured"
            << " against it, write factor -1 at velocity." << exit(FatalError);
    }
}


void Foam::erosionByLaws::integrate(erosion& e, const sectionSeries& s) const
{
    const label n = s.t.size();
    e.byStatic.setSize(n, Zero);
    e.byDynamic.setSize(n, Zero);
    e.byScouring.setSize(n, Zero);
    e.scouringRate = scalarList(n);

    for (label i = 0; i < n; ++i)
    {
        e.scouringRate[i] = scouring_.rate(e.tau[i]);

        if (i)
        {
            // What the state at the begin of a step erodes during it
            const label j = i - 1;
            const scalar dt = s.t[i] - s.t[j];
            e.byStatic[i] = deeper
            (
                e.byStatic[j], laws_.staticDepth(e.tau[j], s.sigma[j])
            );
            e.byDynamic[i] = deeper
            (
                e.byDynamic[j],
                dt*laws_.dynamicRate(e.tau[j], s.sigma[j], s.v[j])
            );
            e.byScouring[i] = deeper(e.byScouring[j], dt*e.scouringRate[j]);
        }
    }
}


Foam::List<Foam::erosionByLaws::erosion> Foam::erosionByLaws::of
(
    const sectionSeries& s
) const
{
    checkSigns(s);

    const label n = s.t.size();
    DynamicList<erosion> all;
    erosion Coulomb{"Coulomb", scalarList(n), {}, {}, {}, {}};
    erosion Voellmy{"Voellmy", scalarList(n), {}, {}, {}, {}};
    for (label i = 0; i < n; ++i)
    {
        Coulomb.tau[i] = laws_.Coulomb(s.sigma[i]);
        Voellmy.tau[i] = laws_.Voellmy(s.sigma[i], s.v[i]);
    }

    if (s.tau.size())
    {
        all.append(erosion{"measured", s.tau, {}, {}, {}, {}});
    }
    all.append(Coulomb);
    all.append(Voellmy);

    for (erosion& e : all)
    {
        integrate(e, s);

        if (s.depth.size())
        {
            e.staticError = meanSquare(e.byStatic, s.depth);
            e.dynamicError = meanSquare(e.byDynamic, s.depth);
            e.scouringError = meanSquare(e.byScouring, s.depth);
        }
        if (s.tau.size())
        {
            e.shearError = meanSquare(e.tau, s.tau);
        }
    }

    return List<erosion>(std::move(all));
}
