// SPDX-License-Identifier: GPL-3.0-or-later
// Volume, centre, moments and shares of spheres that overlap, against closed forms.

#include "sphereShares.H"

#include "mathematicalConstants.H"
#include "quaternion.H"

#include <gtest/gtest.h>

#include <cfenv>

using namespace Foam;
using constant::mathematical::pi;

namespace
{

scalar ball(const scalar r)
{
    return 4*pi/3*pow3(r);
}


scalarField radiiOf(const scalar a, const scalar b)
{
    scalarField result(2, a);
    result[1] = b;
    return result;
}


//- Volume that two spheres at distance d hold both
scalar lens(const scalar a, const scalar b, const scalar d)
{
    return
        pi*sqr(a + b - d)*(sqr(d) + 2*d*(a + b) - 3*sqr(a - b))/(12*d);
}


//- Eight spheres at the corners of a cube, as a pebble, and one that sticks out
void cobble(pointField& centres, scalarField& radii)
{
    centres.setSize(9);
    radii = scalarField(9, 0.006);
    for (label i = 0; i < 8; ++i)
    {
        centres[i] = 0.004*vector(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    centres[8] = point(0.009, 0.003, 0.001);
    radii[8] = 0.004;
}


void expectNear(const symmTensor& a, const symmTensor& b, const scalar tolerance)
{
    for (direction k = 0; k < symmTensor::nComponents; ++k)
    {
        EXPECT_NEAR(a[k], b[k], tolerance);
    }
}

} // End anonymous namespace


TEST(sphereUnion, oneSphereHasItsClosedForms)
{
    const scalar r = 0.013;
    const point c(0.3, -2, 7);
    const sphereUnion one(pointField(1, c), scalarField(1, r));

    EXPECT_NEAR(one.volume(), ball(r), 1e-14*ball(r));
    EXPECT_NEAR(one.surface(), 4*pi*sqr(r), 1e-14*4*pi*sqr(r));
    EXPECT_LT(mag(one.centre() - c), 1e-14);
    EXPECT_NEAR(one.equivalentRadius(), r, 1e-14*r);
    EXPECT_NEAR(one.sphericity(), 1, 1e-13);
    const scalar I = 0.4*ball(r)*sqr(r);
    expectNear(one.inertia(), I*symmTensor::I, 1e-13*I);
}


TEST(sphereUnion, twoThatTouchAreTheirSum)
{
    const scalar r = 0.01;
    const pointField centres({point(0, 0, 0), point(2*r, 0, 0)});
    const sphereUnion two(centres, scalarField(2, r));
    const scalar along = 2*0.4*ball(r)*sqr(r);
    const scalar across = along + 2*ball(r)*sqr(r);

    EXPECT_NEAR(two.volume(), 2*ball(r), 1e-13*ball(r));
    EXPECT_LT(mag(two.centre() - point(r, 0, 0)), 1e-15);
    expectNear
    (
        two.inertia(), symmTensor(along, 0, 0, across, 0, across), 1e-12*across
    );
}


TEST(sphereUnion, whatTwoHoldCountsOnce)
{
    const scalar a = 1, b = 0.7;
    // Also where the smaller is nearly held, and along each axis
    for (const scalar d : {0.31, 0.8, 1.2, 1.69})
    {
        for (const vector& way : {vector(1, 0, 0), vector(0, 0, 1), vector(2, -1, 2)/3})
        {
            const sphereUnion two(pointField({point(Zero), d*way}), radiiOf(a, b));
            const scalar V = ball(a) + ball(b) - lens(a, b, d);
            // Heights of the caps that are lost
            const scalar h = a - 0.5*(d + (sqr(a) - sqr(b))/d);
            const scalar k = a + b - d - h;

            EXPECT_NEAR(two.volume(), V, 1e-13*V) << d << ' ' << way.z();
            EXPECT_NEAR
            (
                two.surface(),
                4*pi*(sqr(a) + sqr(b)) - 2*pi*(a*h + b*k),
                1e-11
            );
        }
    }

    const sphereUnion held(pointField({point(Zero), point(0.2, 0, 0)}), radiiOf(a, b));
    EXPECT_NEAR(held.volume(), ball(a), 1e-13);
    const sphereUnion twice(pointField(2, point(Zero)), scalarField(2, a));
    EXPECT_NEAR(twice.volume(), ball(a), 1e-13);
}


TEST(sphereUnion, aRodOfThreeIsFourCapsLess)
{
    const scalar r = 0.01, d = 0.012;
    const sphereUnion rod
    (
        pointField({point(0, -d, 0), point(0, 0, 0), point(0, d, 0)}),
        scalarField(3, r)
    );
    const scalar V = 3*ball(r) - 2*lens(r, r, d);

    EXPECT_NEAR(rod.volume(), V, 1e-13*V);
    EXPECT_LT(rod.inertia().yy(), 0.5*rod.inertia().xx());
}


// Where three or more meet in a point, the turned cuts begin and end elsewhere
TEST(sphereUnion, aTurnedOneIsTheSame)
{
    pointField centres;
    scalarField radii;
    cobble(centres, radii);
    const sphereUnion as(centres, radii);
    const tensor R(quaternion(vector(1, 2, -0.5)/mag(vector(1, 2, -0.5)), 0.7).R());
    const vector away(0.2, 0.3, -0.1);
    const sphereUnion turned((R & centres) + away, radii);

    EXPECT_NEAR(turned.volume(), as.volume(), 1e-12*as.volume());
    EXPECT_NEAR(turned.surface(), as.surface(), 1e-11*as.surface());
    EXPECT_LT(mag(turned.centre() - away - (R & as.centre())), 1e-14);
    const scalar I = as.inertia().xx();
    expectNear(turned.inertia(), symm(R & tensor(as.inertia()) & R.T()), 1e-11*I);
}


// Counted at points of a grid
TEST(sphereUnion, aCobbleHasTheVolumeOfItsPoints)
{
    pointField centres;
    scalarField radii;
    cobble(centres, radii);
    const sphereUnion all(centres, radii);

    constexpr label n = 200;
    const scalar side = 0.028;
    scalar inside = 0;
    point mean(Zero);
    for (label k = 0; k < n*n*n; ++k)
    {
        const point p
        (
            side/n*vector(k % n + 0.5, k/n % n + 0.5, k/n/n + 0.5)
          - vector::uniform(side/2)
        );
        forAll(centres, i)
        {
            if (magSqr(p - centres[i]) < sqr(radii[i]))
            {
                ++inside;
                mean += p;
                break;
            }
        }
    }

    EXPECT_NEAR(all.volume(), inside*pow3(side/n), 5e-4*all.volume());
    EXPECT_LT(mag(all.centre() - mean/inside), 1e-6);
}


TEST(sphereShares, sumToOneAroundTheCentre)
{
    pointField centres;
    scalarField radii;
    cobble(centres, radii);
    const sphereUnion all(centres, radii);
    const scalarField shares(sphereShares(centres, radii, all));

    EXPECT_NEAR(sum(shares), 1, 1e-15);
    EXPECT_GT(min(shares), 0.02);
    EXPECT_LT(mag(sum(shares*(centres - all.centre()))), 1e-14);
}


// OpenFOAM's trap would stop a program
TEST(sphereUnion, takesNoRootOfANegativeNumber)
{
    pointField all;
    scalarField radii;
    cobble(all, radii);
    std::feclearexcept(FE_ALL_EXCEPT);

    // How many are taken at once depends on their number
    for (label n = 1; n <= all.size(); ++n)
    {
        const UList<point> centres(all.data(), n);
        EXPECT_GT(sphereUnion(centres, UList<scalar>(radii.data(), n)).volume(), 0);
        EXPECT_EQ(std::fetestexcept(FE_INVALID), 0) << n;
    }
}


TEST(sphereShares, alikeOnesHaveTheSameWhateverTheyOverlap)
{
    const pointField centres({point(Zero), point(0.012, 0, 0), point(0, 0, 5)});
    const pointField two(SubList<point>(centres, 2));
    const scalarField alike(2, 0.01);
    const scalarField shares(sphereShares(two, alike, sphereUnion(two, alike)));

    EXPECT_NEAR(shares[0], 0.5, 1e-14);
    EXPECT_NEAR(shares[1], 0.5, 1e-14);

    // Of two their centre alone decides
    const scalarField unlike(radiiOf(0.01, 0.005));
    const sphereUnion all(two, unlike);
    const scalarField other(sphereShares(two, unlike, all));
    EXPECT_NEAR(other[1], all.centre().x()/0.012, 1e-13);
}


TEST(sphereShares, refuseASphereThatCountsForNothing)
{
    const pointField centres({point(Zero), point(0.002, 0, 0)});
    const scalarField radii(radiiOf(0.01, 0.005));
    const sphereUnion all(centres, radii);

    EXPECT_THROW(sphereShares(centres, radii, all), error);
}
