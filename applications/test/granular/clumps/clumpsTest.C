// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps of spheres: what the fluid and LIGGGHTS make of them.

#include "clumpSums.H"
#include "clumpsInBox.H"
#include "testNumber.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace clumpsInBox;

namespace
{

const std::string noDrag("interphaseForces { drag { model none; } ");

//- Weight of water in place of a clump [N]
scalar buoyancy()
{
    return 1000*shape().volume()*mag(g);
}


//- In water at rest a clump is carried by the weight of the water in its place, does
//  not turn, and falls by its density
void expectArchimedes(const std::string& orientation, const std::string& contacts)
{
    boxOfWater w(noDrag + "} LIGGGHTS { contacts " + contacts + "; }");
    settings s;
    s.orientation = orientation;
    place(w, s);
    demCoupling coupling(w.box().mesh(), hydrostatics(g));
    coupling.start(w.water());
    const granularPhase& phase = phaseOf(w);
    const wholeClumps start(phase);

    EXPECT_EQ(start.nSpheres, 3);
    EXPECT_TRUE(phase.hasClumps());
    EXPECT_EQ(phase.nBodies(), 1);
    EXPECT_NEAR(start.mass, density*shape().volume(), 1e-13*start.mass);
    EXPECT_LT(mag(start.force + 1000*shape().volume()*g), 1e-12*buoyancy());
    EXPECT_LT(mag(start.torque), 1e-12*buoyancy()*shape().equivalentRadius());

    const scalar solid =
        gSum(coupling.solidFraction()*w.box().mesh().V().field());
    EXPECT_NEAR(solid, shape().volume(), 1e-14*solid);

    coupling.moveGrains();
    const wholeClumps after(phase);
    const scalar speed = (1 - 1000/density)*mag(g)*interval;
    EXPECT_LT(mag(after.velocity + vector(0, 0, speed)), 1e-12*speed);
    EXPECT_LT(mag(after.spin), 1e-12*speed/shape().equivalentRadius());
    EXPECT_LT(mag(after.contactForce), 1e-12*buoyancy());
}


//- Places of the spheres by number, on all ranks
Map<point> places(const granularPhase& phase)
{
    Map<point> result;
    forAll(phase.position(), i)
    {
        result.insert(phase.id()[i], phase.position()[i]);
    }
    Pstream::mapCombineGather(result, plusEqOp<point>());
    Pstream::mapCombineScatter(result);
    return result;
}


//- A clump that spins and flies from one rank to the next, which meet at x = 0.5 m
void expectFlightIsStraight(const word& contacts)
{
    boxOfWater w("fluid none; LIGGGHTS { contacts " + contacts + "; }");
    settings s;
    s.region = "0.44 0.47 0.4 0.6 0.4 0.6";
    s.velocity = "4 0.1 0";
    s.spin = "10 -7 31";
    place(w, s);
    demCoupling alone(w.box().mesh(), vector(Zero));
    const granularPhase& phase = phaseOf(w);
    const wholeClumps start(phase);
    const Map<point> before(places(phase));
    const label n = 30;

    for (label k = 0; k < n; ++k)
    {
        alone.moveGrains();
        alone.locateGrains();
    }
    const wholeClumps end(phase);
    const Map<point> after(places(phase));
    const point expected(start.centre + n*interval*vector(4, 0.1, 0));

    EXPECT_EQ(end.nSpheres, 3);
    EXPECT_GT(end.centre.x(), 0.52);
    EXPECT_LT(mag(end.centre - expected), 1e-12);
    EXPECT_LT(mag(end.velocity - start.velocity), 1e-12);
    for (const label i : before.toc())
    {
        EXPECT_NEAR(mag(after[i] - after[1]), mag(before[i] - before[1]), 1e-13);
    }
}


//- Paths and spins over time of a clump that spins and flies from a place on along x,
//  where sides repeat, and bounces on the base; goes on from a state now and then
List<Pair<vector>> flight
(
    const scalar from,
    const word& contacts,
    const label n,
    const label restartEvery = labelMax
)
{
    testBox shape;
    shape.patches[0] = shape.patches[1] = "cyclic";
    boxOfWater w("fluid none; LIGGGHTS { contacts " + contacts + "; }", shape);
    settings s;
    std::ostringstream region;
    region << from << ' ' << from + 0.04 << " 0.4 0.44 0.02 0.06";
    s.region = region.str();
    s.velocity = "5 0.1 -1";
    s.spin = "10 -7 31";
    place(w, s);
    autoPtr<demCoupling> alone(new demCoupling(w.box().mesh(), g));
    const point start(places(phaseOf(w))[1]);
    List<Pair<vector>> result(n);

    forAll(result, k)
    {
        if (k % restartEvery == restartEvery - 1)
        {
            EXPECT_TRUE(alone->write());
            alone.clear();
            alone.reset(new demCoupling(w.box().mesh(), g));
            EXPECT_TRUE(alone->restarted());
        }
        alone->moveGrains();
        alone->locateGrains();
        const granularPhase& phase = phaseOf(w);
        Map<point> all(places(phase));
        vector path(all[1] - start);
        path.x() -= std::floor(path.x());
        result[k] = Pair<vector>(path, wholeClumps(phase).spin);

        for (const label i : all.toc())
        {
            vector apart(all[i] - all[1]);
            apart.x() -= std::round(apart.x());
            EXPECT_NEAR(mag(apart), mag(centres[i - 1] - centres[0]), 1e-12);
        }
    }

    return result;
}


//- Over the side that repeats, where ranks meet as well, and with a restart in every
//  second interval, as elsewhere
void expectTheSameOverASide(const word& contacts)
{
    const label n = 35;
    const auto over = flight(0.875, contacts, n, 2);
    // On the same rank, of 4 at most, which puts it into the same place
    const auto within = flight(0.755, contacts, n);

    forAll(over, k)
    {
        EXPECT_LT(mag(over[k].first() - within[k].first()), 1e-9) << k;
        EXPECT_LT(mag(over[k].second() - within[k].second()), 1e-6) << k;
    }
    // It did touch the base
    EXPECT_GT(mag(within[n - 1].second() - within[0].second()), 1);
}


void expectSumsOverRanks()
{
    // Spheres of clump 7 are on all ranks, those of 3 on the last alone
    const label me = Pstream::myProcNo();
    const label n = Pstream::nProcs();
    const bool last = me == n - 1;
    const labelList clump(last ? labelList({7, 0, 3, 3}) : labelList({7, 0}));
    vectorField values(clump.size(), vector(1, 2, me));
    vectorField others(clump.size(), vector(0, -1, 0));
    const Map<Pair<vector>> sums(clumpSums(clump).sum(values, others));

    EXPECT_EQ(sums.size(), last ? 2 : 1);
    EXPECT_EQ(sums[7].first(), vector(n, 2*n, n*(n - 1)/2));
    EXPECT_EQ(sums[7].second(), vector(0, -n, 0));
    if (last)
    {
        EXPECT_EQ(sums[3].first(), vector(2, 4, 2*me));
    }
    EXPECT_EQ(nClumps(clump), 2);
}

} // End anonymous namespace


TEST(clumpSums, addUpWhatIsHere)
{
    expectSumsOverRanks();
}


TEST(ParallelClumpSums, addUpWhatIsOnAnyRank)
{
    expectSumsOverRanks();
}


TEST(clumps, areCarriedByTheWaterInTheirPlaceHoweverTheyLie)
{
    expectArchimedes("1 0 0 0", "vectorised");
    expectArchimedes("0.8 0.36 0.48 0", "vectorised");
    expectArchimedes("0.1 0.7 -0.5 0.5", "stock");
}


TEST(ParallelClumps, areCarriedByTheWaterInTheirPlaceHoweverTheyLie)
{
    expectArchimedes("0.8 0.36 0.48 0", "vectorised");
    expectArchimedes("0.1 0.7 -0.5 0.5", "stock");
}


TEST(clumps, flyStraightWhileTheySpin)
{
    expectFlightIsStraight("vectorised");
}


TEST(ParallelClumps, flyStraightFromRankToRank)
{
    expectFlightIsStraight("vectorised");
}


TEST(clumps, passASideThatRepeats)
{
    expectTheSameOverASide("vectorised");
    expectTheSameOverASide("stock");
}


TEST(ParallelClumps, passASideThatRepeats)
{
    expectTheSameOverASide("vectorised");
    expectTheSameOverASide("stock");
}


// It tumbles: its axis is none of its principal ones
TEST(clumps, aFreeOneKeepsItsEnergyAndAngularMomentumOver100000Steps)
{
    boxOfWater w("fluid none;");
    settings s;
    s.spin = "3 40 1";
    place(w, s);
    demCoupling alone(w.box().mesh(), vector(Zero));
    const granularPhase& phase = phaseOf(w);

    // By the spheres as they lie now
    const auto motion = [&]()
    {
        const sphereUnion body
        (
            pointField(phase.position()), scalarField(phase.radius())
        );
        const vector L(density*body.inertia() & phase.angularVelocity()[0]);
        return Tuple2<scalar, vector>(0.5*(L & phase.angularVelocity()[0]), L);
    };
    const auto start(motion());
    const vector spin(phase.angularVelocity()[0]);
    scalar energy = 0, momentum = 0, turned = 0;

    for (label k = 0; k < 2000; ++k)
    {
        alone.moveGrains();
        if (k % 20 == 19)
        {
            const auto now(motion());
            energy = max(energy, mag(now.first()/start.first() - 1));
            momentum = max
            (
                momentum, mag(now.second() - start.second())/mag(start.second())
            );
            turned = max(turned, mag(phase.angularVelocity()[0] - spin)/mag(spin));
        }
    }

    testNumber("energy lost", energy);
    testNumber("angular momentum changed", momentum);
    EXPECT_LT(energy, 1e-8);
    EXPECT_LT(momentum, 1e-11);
    EXPECT_GT(turned, 0.1);
}


// Of the shares of the spheres and of the whole
TEST(clumps, theirSpheresShowSharesOfTheWhole)
{
    boxOfWater w(noDrag + "}");
    place(w);
    demCoupling coupling(w.box().mesh(), hydrostatics(g));
    coupling.start(w.water());
    exchangeOnce(coupling, w);
    const granularPhase& phase = phaseOf(w);

    EXPECT_NEAR(sum(phase.share()), 1, 1e-15);
    const vector total(sum(vectorField(phase.totalForce())));
    const vector expected((1 - 1000/density)*shape().volume()*density*g);
    EXPECT_LT(mag(total - expected), 1e-12*mag(expected));

    forAll(phase.clump(), i)
    {
        EXPECT_EQ(phase.clump()[i], 1);
        EXPECT_TRUE(phase.mobile(i));
        EXPECT_NEAR
        (
            phase.clumpRadius()[i], shape().equivalentRadius(), 1e-14
        );
        EXPECT_LT
        (
            mag(phase.totalForce()[i] - phase.share()[i]*total), 1e-13*mag(total)
        );
    }
}


// On the base at once: the wall bears what the water does not
TEST(clumps, thatLieOnTheBaseDragNoLoadOntoTheWater)
{
    boxOfWater w;
    settings s;
    s.region = "0.3 0.7 0.3 0.7 0.01 0.03";
    s.physics = "timestep 1e-5\n";
    place(w, s);
    demCoupling coupling(w.box().mesh(), hydrostatics(g));
    coupling.start(w.water());
    for (label k = 0; k < 1500; ++k)
    {
        exchangeOnce(coupling, w);
    }
    const wholeClumps end(phaseOf(w));
    const scalar weight = shape().volume()*density*mag(g);

    EXPECT_LT(mag(end.velocity), 1e-3);
    EXPECT_NEAR(end.contactForce.z(), weight - buoyancy(), 0.01*weight);
    EXPECT_NEAR(end.force.z(), buoyancy(), 0.01*weight);
    const scalar lever = end.centre.z()*end.contactForce.z();
    EXPECT_NEAR(end.stressMoment.zz(), -lever, 0.01*lever);
}
