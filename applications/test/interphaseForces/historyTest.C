// SPDX-License-Identifier: GPL-3.0-or-later
// The history force: its memory against the formula, and two motions of a sphere
// that are known.

#include "interphaseForces.H"
#include "standingGrains.H"
#include "testMesh.H"
#include "testNumber.H"

#include "IFstream.H"
#include "IStringStream.H"
#include "Pstream.H"
#include "OSspecific.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;

namespace
{

constexpr scalar pi = M_PI;
constexpr scalar d = 0.015;
constexpr scalar rho = 970;
constexpr scalar mu = 0.373;
constexpr scalar interval = 1e-3;

const scalar Basset = 1.5*sqr(d)*std::sqrt(pi*rho*mu);

dictionary entries(const string& text)
{
    return dictionary(IStringStream(text)());
}


//- Mean over an interval of the force of a slip that changed by 1 within an
//  interval so many intervals ago, without Basset's factor
scalar exactWeight(const label j)
{
    return
        4.0/3/std::sqrt(interval)
       *(
            std::pow(j + 1., 1.5) - 2*std::pow(scalar(j), 1.5)
          + std::pow(j - 1., 1.5)
        );
}


//- One sphere in a box of fluid
struct sphere
{
    testMesh box;

    standingGrains phase;

    grainExchange exchange;

    autoPtr<solidFractionField> solids;

    autoPtr<interphaseForces> forces;

    scalar mass = 1120*pi/6*pow3(d);

    sphere(const string& laws, const bool mobile)
    :
        phase(box.mesh()),
        exchange(box.mesh())
    {
        phase.grains = grainSnapshot(1);
        phase.grains.id = identity(1);
        phase.grains.position = point(0.4, 0.4, 0.4);
        phase.grains.mass = mass;
        phase.radii = scalarField(1, 0.5*d);
        if (!mobile)
        {
            phase.held.insert(0);
        }
        exchange.locate(phase);
        solids.reset
        (
            new solidFractionField
            (
                exchange, entries("model centroid; smoothing { model none; }")
            )
        );
        solids->update();
        forces.reset
        (
            new interphaseForces
            (
                exchange, *solids,
                entries("rotationalDrag { model none; }" + laws),
                vector(Zero), 1
            )
        );
    }

    //- With the fluid's velocity when the interval begins, and its change
    vector force(const vector& U, const vector& acceleration)
    {
        const label n = box.mesh().nCells();
        const vectorField none(n, Zero);
        const scalarField one(n, 1);
        exchange.locate(phase);
        solids->update();
        const vectorField at(n, U);
        forces->prepare
        (
            fluidFields{rho*one, mu*one, one, at, none, none, none}, interval
        );
        forces->finish
        (
            fluidMeans
            {
                vectorField(n, U + 0.5*interval*acceleration),
                vectorField(n, acceleration), none, none, rho*one, Zero
            }
        );
        return forces->force()[0];
    }
};

} // End anonymous namespace


TEST(history, remembersByOneOverTheRootOfTime)
{
    historyForce h(entries("window 1;"));
    h.begin(List<locatedGrain>(), interval);
    const auto error = [&](const label j)
    {
        return mag(h.weight(j)/exactWeight(j) - 1);
    };

    for (const label j : {1, 2, 3, 10, 30, 100})
    {
        EXPECT_LT(error(j), 0.005) << j;
    }
    testNumber("error of the memory at the end of the window", error(1000));
    EXPECT_LT(error(1000), 0.05);

    // Beyond it fades
    EXPECT_LT(h.weight(100000), 0.1*exactWeight(100000));
}


TEST(history, ofAnEvenAccelerationGrowsWithTheRootOfTime)
{
    sphere s("drag { model none; } history { window 10; }", false);
    const scalar a = 2;

    for (label n = 0; n < 300; ++n)
    {
        const vector f(s.force(vector(a*n*interval, 0, 0), vector(a, 0, 0)));

        // Mean over the interval of F = 2 a sqrt(t) times Basset's factor
        const scalar exact =
            4.0/3*a*Basset*std::sqrt(interval)
           *(std::pow(n + 1., 1.5) - std::pow(scalar(n), 1.5));
        ASSERT_NEAR(f.x()/exact, 1, 0.01) << n;
    }
}


TEST(history, goesOnWhereItWasWritten)
{
    const string laws("drag { model none; } history { window 0.5; }");
    const fileName folder("historyTest.written");
    mkDir(folder);
    const vector a(3, -1, 0.5);
    const auto next = [&](sphere& s, const label from, const label to)
    {
        vector F(Zero);
        for (label i = from; i < to; ++i)
        {
            F = s.force(i*interval*a, a);
        }
        return F;
    };

    sphere through(laws, false);
    next(through, 0, 7);
    ASSERT_TRUE(through.forces->writeState(folder));

    sphere goesOn(laws, false);
    goesOn.forces->readState(folder);
    sphere anew(laws, false);
    EXPECT_EQ(next(goesOn, 7, 9), next(through, 7, 9));
    EXPECT_GT(mag(next(goesOn, 9, 10) - next(anew, 9, 10)), 1e-3);

    // Of another window it is of no use
    sphere other("drag { model none; } history { window 1; }", false);
    other.forces->readState(folder);
    sphere fresh("drag { model none; } history { window 1; }", false);
    EXPECT_EQ(next(other, 7, 9), next(fresh, 7, 9));
    rmDir(folder);
}


TEST(history, ofAStrengthIsThatShare)
{
    sphere all("drag { model none; } history { }", false);
    sphere half("drag { model none; } history { strength 0.5; }", false);
    sphere none("drag { model none; } history { strength 0; }", false);
    const vector a(1, 0, 0);
    for (label n = 0; n < 5; ++n)
    {
        const vector U(n*interval*a);
        const vector f(all.force(U, a));
        EXPECT_NEAR(half.force(U, a).x()/f.x(), 0.5, 1e-12);
        EXPECT_EQ(none.force(U, a), vector(Zero));
    }
}


TEST(history, slowsASphereThatIsLetGoAsTheEquationHasIt)
{
    // m dv/dt = F - K v - C_B int v'/sqrt(t-s) ds from rest, with a tenth of the
    // step and the sum over all of the past
    const scalar drive = 2e-3;
    const scalar K = 3*pi*mu*d;
    const label fine = 10;
    const scalar dt = interval/fine;
    sphere s
    (
        "drag { model SchillerNaumann; } history { window 10; }", true
    );
    const scalar m = s.mass;

    List<scalar> change;
    scalar v = 0;
    scalar computed = 0;
    for (label n = 0; n < 60; ++n)
    {
        for (label k = 0; k < fine; ++k)
        {
            scalar past = 0;
            const label i = change.size();
            for (label j = 0; j < i; ++j)
            {
                past +=
                    change[j]/dt*2*std::sqrt(dt)
                   *(std::sqrt(i - j + 1.) - std::sqrt(scalar(i - j)));
            }
            const scalar C = Basset*2*std::sqrt(dt);
            const scalar dv =
                (drive - K*v - Basset*past)*dt/(m + C + K*dt);
            change.append(dv);
            v += dv;
        }

        // Stokes: Re 1e-2 at most
        vector& U = s.phase.grains.U[0];
        U.x() = computed;
        const vector f(s.force(vector::zero, vector::zero));
        computed += interval/m*f.x();

        // The drive, behind the drag as a load
        computed += interval*drive/(m + K*interval + 4.0/3*std::sqrt(interval)*Basset);
        if (n > 5)
        {
            ASSERT_NEAR(computed/v, 1, 0.03) << n;
        }
    }

    // Without the past it would be faster
    const scalar alone = drive/K*(1 - std::exp(-K/m*60*interval));
    testNumber("velocity over that without history", v/alone);
    EXPECT_LT(v/alone, 0.9);
}


TEST(ParallelHistory, thePastIsWrittenInPiecesAndReadInShares)
{
    // On each rank more than one piece
    const label nRanks = Pstream::nProcs();
    const label nGrains = 10000*nRanks;
    const fileName folder("historyTest.pieces");
    mkDir(folder);
    grainState state;
    state.d = d;
    state.rho = rho;
    state.mu = mu;
    const auto grainsOf = [&](const label turn)
    {
        DynamicList<locatedGrain> here(nGrains/nRanks + 1);
        for (label id = 1; id <= nGrains; ++id)
        {
            if ((id + turn) % nRanks == Pstream::myProcNo())
            {
                here.append(locatedGrain());
                here.last().id = id;
            }
        }
        return List<locatedGrain>(std::move(here));
    };
    const auto advance = [&](historyForce& h, const label turn, const label k)
    {
        const List<locatedGrain> here(grainsOf(turn));
        h.begin(here, interval);
        vectorField forces(here.size());
        forAll(here, i)
        {
            state.slip = vector(here[i].id, k*k, 1);
            forces[i] = h.force(here[i].id, state);
        }
        return forces;
    };
    const auto piecesOf = [&]()
    {
        IFstream is(folder/"history", IOstream::BINARY);
        scalarList times;
        List<labelList> ids;
        is >> times >> ids;
        return ids;
    };

    historyForce through(entries("window 0.1;"));
    advance(through, 0, 0);
    advance(through, 0, 1);
    const bool complete = through.write(folder);
    EXPECT_TRUE(complete);
    if (Pstream::master())
    {
        const List<labelList> pieces(piecesOf());
        EXPECT_EQ(pieces.size(), 2*nRanks);
        label n = 0;
        for (const labelList& piece : pieces)
        {
            EXPECT_LE(piece.size(), 8192);
            n += piece.size();
        }
        EXPECT_EQ(n, nGrains);
    }

    // The grains have changed their ranks where the run goes on
    historyForce goesOn(entries("window 0.1;"));
    goesOn.read(folder);
    const vectorField expected(advance(through, 1, 2));
    EXPECT_EQ(advance(goesOn, 1, 2), expected);
    EXPECT_GT(gMax(mag(expected)()), 0);

    // What is read is shared out before a grain is known
    historyForce first(entries("window 0.1;"));
    first.read(folder);
    EXPECT_TRUE(first.write(folder));
    if (Pstream::master())
    {
        EXPECT_EQ(piecesOf().size(), 2*nRanks);
        rmDir(folder);
    }
}


TEST(ParallelHistory, thePastGoesWithItsGrain)
{
    const label nGrains = 50;
    const label nRanks = Pstream::nProcs();
    historyForce moving(entries("window 1;"));
    historyForce staying(entries("window 1;"));
    grainState state;
    state.d = d;
    state.rho = rho;
    state.mu = mu;

    // In "moving" a grain goes on to another rank with each interval
    for (label k = 0; k < 6; ++k)
    {
        List<locatedGrain> here;
        List<locatedGrain> all;
        for (label id = 1; id <= nGrains; ++id)
        {
            locatedGrain grain;
            grain.id = id;
            all.append(grain);
            if ((id + k) % nRanks == Pstream::myProcNo())
            {
                here.append(grain);
            }
        }
        moving.begin(here, interval);
        staying.begin(all, interval);

        labelHashSet mine;
        for (const locatedGrain& grain : here)
        {
            mine.insert(grain.id);
        }
        for (const locatedGrain& grain : all)
        {
            state.slip = vector(grain.id, k*k, 1);
            const vector expected(staying.force(grain.id, state));
            if (mine.found(grain.id))
            {
                EXPECT_EQ(moving.force(grain.id, state), expected);
                EXPECT_TRUE(k == 0 || mag(expected) > 0);
            }
        }
    }
}
