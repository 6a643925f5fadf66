// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: drag of grains that are not spheres.

#include "forceLaws.H"
#include "shapeFactor.H"

using namespace Foam;
using namespace Foam::forceLaws;

namespace
{

const char* const names[]{"HolzerSommerfeld", "Ganser"};


autoPtr<shapeFactor> shape(const std::string& name)
{
    return law<shapeFactor>("model " + name + ";");
}


//- C_d of the law
scalar coefficient
(
    const std::string& name,
    const scalar Re,
    const scalar sphericity,
    const scalar crosswiseSphericity
)
{
    return
        24/Re*shape(name)->overStokes(Re, sphericity, crosswiseSphericity);
}


//- A grain at Re 30 by the superficial slip
grainState stone()
{
    grainState state = atReynolds(inWater(), 50);
    state.voidFraction = 0.6;
    return state;
}


//- The drag law DiFelice with the entries of shape
std::string shaped(const std::string& entries)
{
    return "model DiFelice; shape { " + entries + " }";
}


scalar plainK()
{
    return law<dragModel>("model DiFelice;")->K(stone());
}


//- Drag with these entries of shape over the drag without
scalar ratio(const std::string& entries)
{
    return law<dragModel>(shaped(entries))->K(stone())/plainK();
}


std::string text(const scalar s)
{
    std::ostringstream os;
    os.precision(17);
    os << s;
    return os.str();
}

} // End anonymous namespace


TEST(shapeFactor, ofASphereIsOneToTheLastBit)
{
    for (const char* name : names)
    {
        for (const scalar Re : {0.0, 1e-6, 1.0, 1e5})
        {
            EXPECT_EQ(shape(name)->factor(Re, 1, 1), 1) << name << ' ' << Re;
        }
    }
}


TEST(shapeFactor, isTheDragOfThePublishedLawOverTheStandardCurve)
{
    for (const char* name : names)
    {
        for (const scalar Re : {0.1, 1.0, 10.0, 100.0, 300.0})
        {
            EXPECT_NEAR
            (
                shape(name)->factor(Re, 0.7, 0.8)*(1 + 0.15*std::pow(Re, 0.687))
               /shape(name)->overStokes(Re, 0.7, 0.8),
                1,
                1e-12
            ) << name << ' ' << Re;
        }
    }
}


TEST(shapeFactor, curvesOfASphereAreNearTheStandardCurve)
{
    // Fitted to all shapes: at Re 300 that of Ganser is 28 % too low
    const auto worst = [](const std::string& name)
    {
        scalar most = 0;
        for (const scalar Re : {0.0, 0.1, 1.0, 10.0, 100.0, 300.0})
        {
            most = max
            (
                most,
                mag(shape(name)->overStokes(Re, 1, 1)
               /(1 + 0.15*std::pow(Re, 0.687)) - 1)
            );
        }
        return most;
    };

    EXPECT_LT(worst("HolzerSommerfeld"), 0.13);
    EXPECT_LT(worst("Ganser"), 0.30);
}


TEST(shapeFactor, hasTheNumbersOfThePapers)
{
    // A cube, broadside, by hand from the printed formulae
    const scalar p = std::cbrt(M_PI/6);
    const scalar c = 0.25*M_PI*std::pow(6/M_PI, 2.0/3);

    EXPECT_NEAR(p, 0.80600, 1e-5);
    EXPECT_NEAR(c, 1.20899, 1e-5);
    EXPECT_NEAR
    (
        coefficient("HolzerSommerfeld", 100, p, c),
        8/(100*1.099543) + 16/(100*0.897773) + 3/(10*0.850648)
      + 0.42*1.774607/1.208994,
        1e-5
    );
    EXPECT_NEAR
    (
        coefficient("Ganser", 100, 0.806, 1),
        2.922850*(24/271.66306*(1 + 0.1118*39.66687) + 0.4305/(1 + 3305/271.66306)),
        1e-5
    );
}


TEST(shapeFactor, ofIsometricGrainsIsThatOfPettyjohnAndChristiansen)
{
    // 1948, Chem. Eng. Prog. 44, 157-172: cube octahedron, cube, tetrahedron
    for (const scalar p : {0.906, 0.806, 0.670})
    {
        const scalar Stokes = 1/(0.843*std::log10(p/0.065));

        EXPECT_NEAR(shape("Ganser")->overStokes(0, p, 1)/Stokes, 1, 0.03) << p;
        EXPECT_NEAR
        (
            shape("HolzerSommerfeld")->overStokes(0, p, p)/Stokes, 1, 0.06
        ) << p;

        EXPECT_NEAR
        (
            coefficient("Ganser", 1e7, p, 1)/(5.31 - 4.88*p), 1, 0.15
        ) << p;
    }
}


TEST(shapeFactor, HolzerSommerfeldHasNewtonsDragOfADisc)
{
    // 1.17 by the area of the disc
    const scalar p = 0.05, c = 0.2;

    EXPECT_NEAR(coefficient("HolzerSommerfeld", 1e8, p, c)*c/1.17, 1, 0.06);
}


TEST(shapeFactor, isLargerForAFlatterGrain)
{
    for (const char* name : names)
    {
        for (const scalar Re : {0.0, 1.0, 100.0, 1e4})
        {
            scalar before = shape(name)->overStokes(Re, 1, 1);

            for (const scalar p : {0.95, 0.8, 0.6, 0.3})
            {
                const scalar now = shape(name)->overStokes(Re, p, 1);
                EXPECT_GT(now, before) << name << ' ' << Re << ' ' << p;
                before = now;
            }
        }
    }
}


TEST(shapedDrag, multipliesAnyLawAtTheReynoldsNumberOfTheSuperficialSlip)
{
    for (const std::string dense : {"DiFelice", "Gidaspow", "KochHill", "Beetstra"})
    {
        for (const std::string name : names)
        {
            EXPECT_NEAR
            (
                law<dragModel>
                (
                    "model " + dense + "; shape { model " + name
                  + "; sphericity 0.7; crosswiseSphericity 0.8; }"
                )->K(stone())
               /law<dragModel>("model " + dense + ";")->K(stone())
               /shape(name)->factor(0.6*50, 0.7, 0.8),
                1,
                1e-14
            ) << dense << ' ' << name;
        }
    }
}


TEST(shapedDrag, isTheLawForASphereToTheLastBit)
{
    for (const std::string name : names)
    {
        EXPECT_EQ
        (
            law<dragModel>
            (
                shaped("model " + name + "; sphericity 1;")
            )->K(stone()),
            plainK()
        ) << name;
    }
}


TEST(shapedDrag, isOffWithoutALawOrAStrength)
{
    for
    (
        const std::string off :
        {
            "model none;",
            "model none; sphericity 0.7;",
            "model Ganser; sphericity 0.7; strength 0;"
        }
    )
    {
        EXPECT_EQ(law<dragModel>(shaped(off))->K(stone()), plainK()) << off;
    }
    EXPECT_FALSE
    (
        law<dragModel>("model none; shape { model Ganser; sphericity 0.7; }").valid()
    );
}


TEST(shapedDrag, takesTheMeanOverAllDirectionsWhereNoneIsGiven)
{
    EXPECT_EQ
    (
        ratio("model HolzerSommerfeld; sphericity 0.7;"),
        ratio("model HolzerSommerfeld; sphericity 0.7; crosswiseSphericity 0.7;")
    );
}


TEST(shapedDrag, holdsForItsDiametersAlone)
{
    const std::string entries("model Ganser; sphericity 0.7; diameters ");

    EXPECT_GT(ratio(entries + "(0.9e-3 1.1e-3);"), 1.1);
    EXPECT_EQ(ratio(entries + "(1.1e-3 1);"), 1);
    EXPECT_EQ(ratio(entries + "(0 0.9e-3);"), 1);
}


TEST(shapedDrag, isTheSameForManyAndForOne)
{
    const auto drag = law<dragModel>
    (
        shaped("model HolzerSommerfeld; sphericity 0.7; diameters (0.8e-3 1);")
    );
    List<grainState> states(3, stone());
    states[1].d = 0.5e-3;
    states[2].voidFraction = 0.9;
    scalarList K(3);
    drag->K(states, K);

    forAll(states, i)
    {
        EXPECT_NEAR(K[i]/drag->K(states[i]), 1, 1e-12) << i;
    }
}


TEST(shapedDrag, isFiniteAtRest)
{
    grainState rest = stone();
    rest.slip = Zero;

    for (const std::string name : names)
    {
        const scalar K = law<dragModel>
        (
            shaped("model " + name + "; sphericity 0.6;")
        )->K(rest);

        EXPECT_GT(K/law<dragModel>("model DiFelice;")->K(rest), 1) << name;
        EXPECT_LT(K/law<dragModel>("model DiFelice;")->K(rest), 1.5) << name;
    }
}


TEST(shapedDrag, strengthGoesFromTheLawToTheShape)
{
    const std::string entries("model Ganser; sphericity 0.7; ");
    const scalar full = ratio(entries);

    for (const scalar s : {0.0, 0.3, 1.0})
    {
        EXPECT_NEAR
        (
            ratio(entries + "strength " + text(s) + ";"),
            1 + s*(full - 1),
            1e-14
        ) << s;
    }
}


TEST(shapedDrag, namesWhatIsValid)
{
    const auto refuses =
        [](const std::string& entries, std::initializer_list<std::string> words)
    {
        expectError<dragModel>(shaped(entries), words);
    };

    refuses("", {"model", "Ganser", "HolzerSommerfeld"});
    refuses
    (
        "model Gansser; sphericity 0.7;", {"Gansser", "Ganser", "none"}
    );
    refuses("model Ganser;", {"sphericity"});
    refuses("model Ganser; strength 0;", {"sphericity"});
    refuses("model Ganser; sphericty 0.8;", {"sphericty", "sphericity"});
    refuses
    (
        "model Ganser; sphericity 0.8; strength 2;", {"strength", "between 0"}
    );
    refuses("model Ganser; sphericity 0;", {"sphericity 0", "above 0"});
    refuses("model Ganser; sphericity 1.2;", {"sphericity 1.2", "at most 1"});
    refuses
    (
        "model Ganser; sphericity 0.8; crosswiseSphericity -1;",
        {"crosswiseSphericity -1", "Leave it out"}
    );
    refuses
    (
        "model Ganser; sphericity 0.8; diameters (2 1);",
        {"diameters", "smallest comes first"}
    );
    expectError<dragModel>("model DiFelice; shape Ganser;", {"shape"});
}
