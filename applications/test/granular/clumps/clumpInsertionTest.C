// SPDX-License-Identifier: GPL-3.0-or-later
// Clumps from a file: each where it is listed and turned so, on any ranks.

#include "clumpTable.H"
#include "clumpsInBox.H"
#include "temporaryFolder.H"
#include "terminalOutput.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace clumpsInBox;

namespace
{

quaternion turned(const vector& axis, const scalar angle)
{
    return quaternion(axis/mag(axis), angle);
}


//- On both sides of x = 0.5 m, where ranks meet, one across it, one beyond x = 0
DynamicList<placedClump> listed()
{
    DynamicList<placedClump> result;
    result.append({"stone", point(0.8, 0.2, 0.3), turned(vector(1, 2, 3), 0.7)});
    result.append({"stone", point(0.2, 0.2, 0.3), turned(vector(0, 1, 0), 3)});
    result.append({"other", point(0.5, 0.6, 0.4), turned(vector(-1, 0, 1), 1.9)});
    result.append({"stone", point(0.003, 0.7, 0.6), quaternion(1)});
    result.append({"other", point(0.3, 0.3, 0.7), turned(vector(3, 0, -2), -1)});
    return result;
}


//- Two unlike spheres
const pointField otherCentres({point(0, 0, 0), point(0, 0.012, 0)});

scalarField otherRadii()
{
    scalarField result(2, 0.01);
    result[1] = 0.006;
    return result;
}


std::string templateOf
(
    const std::string& name,
    const pointField& centres,
    const scalarField& radii,
    const label number
)
{
    std::ostringstream os;
    os.precision(17);
    os  << "fix " << name << " all particletemplate/multisphere 15485863 atom_type 1"
        << " density constant 2500 nspheres " << centres.size()
        << " ntry 1000 spheres";
    forAll(centres, i)
    {
        const point& c = centres[i];
        os  << ' ' << c.x() << ' ' << c.y() << ' ' << c.z() << ' ' << radii[i];
    }
    os << " type " << number << "\n";
    return os.str();
}


//- Write clumps and the scripts that insert them, beside two grains alone
void writeCase
(
    boxOfWater& w,
    const UList<placedClump>& clumps,
    const std::string& insertion = "fix insertion all insert/clumps file clumps\n"
)
{
    const fileName file(w.box().folder()/"clumps");
    if (Pstream::master())
    {
        writeClumpTable(file, clumps);
    }
    w.write
    (
        "constant/grains/initial",
        "units si\natom_style granular\natom_modify map array\nnewton off\n"
        "communicate single vel yes\nregion box block 0 1 0 1 0 1 units box\n"
        "create_box 1 box\n"
        "create_atoms 1 single 0.2 0.8 0.8 units box\n"
        "create_atoms 1 single 0.7 0.8 0.8 units box\n"
        "set type 1 diameter 0.02 density 2500\n"
        "fix clumps all multisphere\n"
      + templateOf("stone", centres, radii(), 1)
      + templateOf("other", otherCentres, otherRadii(), 2)
      + insertion
    );
    std::ostringstream cut;
    cut << "method simple; simpleCoeffs { n (" << Pstream::nProcs() << " 1 1); }\n";
    w.write("system/decomposeParDict", cut.str());
    w.writePhysics("");
}


//- Place of sphere k of a clump
point expected(const placedClump& clump, const label k)
{
    const bool stone = clump.kind == "stone";
    const pointField& c = stone ? centres : otherCentres;
    const scalarField r(stone ? radii() : otherRadii());

    return
        clump.centre
      + (clump.orientation.R() & (c[k] - sphereUnion(c, r).centre()));
}


//- Clump and place of the spheres by number, on all ranks
Map<Tuple2<label, point>> spheres(const granularPhase& phase)
{
    Map<point> place;
    Map<label> clump;
    forAll(phase.position(), i)
    {
        place.insert(phase.id()[i], phase.position()[i]);
        clump.insert(phase.id()[i], phase.clump()[i]);
    }
    Pstream::mapCombineGather(place, plusEqOp<point>());
    Pstream::mapCombineScatter(place);
    Pstream::mapCombineGather(clump, plusEqOp<label>());
    Pstream::mapCombineScatter(clump);

    Map<Tuple2<label, point>> result;
    forAllConstIters(place, p)
    {
        result.insert(p.key(), {clump[p.key()], *p});
    }
    return result;
}


//- Each sphere has the number, the clump and the place of the list
void expectAsListed(const granularPhase& phase, const scalar tolerance)
{
    const auto all = spheres(phase);
    label id = 3, number = 0;

    for (const placedClump& clump : listed())
    {
        ++number;
        for (label k = 0; k < (clump.kind == "stone" ? 3 : 2); ++k)
        {
            vector off(all[id].second() - expected(clump, k));
            off.x() -= std::round(off.x());
            EXPECT_LT(mag(off), tolerance) << id;
            EXPECT_EQ(all[id].first(), number) << id;
            ++id;
        }
    }
    EXPECT_EQ(all.size(), id - 1);
    EXPECT_EQ(phase.nTotal(), id - 1);
    EXPECT_EQ(phase.nBodies(), number + 2);
}


//- The ellipsoid of each sphere has the second moments of its clump, turned as listed
void expectTurnedAsListed(const granularPhase& phase)
{
    const auto grains(phase.snapshot());
    label nSeen = 0;

    forAll(grains->clump, i)
    {
        const vector& v = grains->orientation[i];
        const vector& axes = grains->axes[i];
        if (!grains->clump[i])
        {
            EXPECT_EQ(v, vector::zero);
            EXPECT_EQ(axes, vector::one*grains->d[i]);
            continue;
        }

        const placedClump clump(listed()[grains->clump[i] - 1]);
        const bool stone = clump.kind == "stone";
        const sphereUnion all
        (
            stone ? centres : otherCentres, stone ? radii() : otherRadii()
        );
        const symmTensor inertia(all.inertia()/all.volume());
        const tensor own(0.5*tr(inertia)*tensor::I - tensor(inertia));
        const tensor R(clump.orientation.R());
        const tensor expected(R & own & R.T());

        const tensor Q(quaternion(Foam::sqrt(1 - magSqr(v)), v).R());
        const tensor diagonal
        (
            sqr(axes.x())/20, 0, 0, 0, sqr(axes.y())/20, 0, 0, 0, sqr(axes.z())/20
        );
        EXPECT_LT(mag((Q & diagonal & Q.T()) - expected), 1e-9*tr(expected));
        ++nSeen;
    }
    EXPECT_EQ(returnReduce(nSeen, sumOp<label>()), 13);
}


testBox periodicBox()
{
    testBox box;
    box.patches[0] = box.patches[1] = "cyclic";
    return box;
}


void expectInsertedAsListed(const std::string& contacts)
{
    boxOfWater w("fluid none; LIGGGHTS { contacts " + contacts + "; }", periodicBox());
    writeCase(w, listed());
    autoPtr<demCoupling> alone(new demCoupling(w.box().mesh(), vector(Zero)));
    expectAsListed(phaseOf(w), 1e-12);
    expectTurnedAsListed(phaseOf(w));
    EXPECT_FALSE(alone->restarted());

    // At rest, and from a state
    alone->moveGrains();
    alone->locateGrains();
    expectAsListed(phaseOf(w), 1e-12);
    EXPECT_TRUE(alone->write());
    alone.clear();
    alone.reset(new demCoupling(w.box().mesh(), vector(Zero)));
    EXPECT_TRUE(alone->restarted());
    expectAsListed(phaseOf(w), 1e-12);
    alone->moveGrains();
    expectAsListed(phaseOf(w), 1e-12);
}


//- The error of a case with these clumps and insertion
std::string refused
(
    const UList<placedClump>& clumps,
    const std::string& insertion = "fix insertion all insert/clumps file clumps\n"
)
{
    return refusal([&]
    {
        boxOfWater w("fluid none;");
        writeCase(w, clumps, insertion);
        demCoupling alone(w.box().mesh(), vector(Zero));
    });
}


//- The error of reading such a table
std::string unreadable(const std::string& text)
{
    const temporaryFolder folder;
    const fileName file(fileName(folder)/"clumps");
    std::ofstream(file) << text;
    return refusal([&] { readClumpTable(file); });
}

} // End anonymous namespace


TEST(clumpInsertion, putsEachWhereItIsListed)
{
    expectInsertedAsListed("vectorised");
    expectInsertedAsListed("stock");
}


TEST(ParallelClumpInsertion, putsEachWhereItIsListedByTheSameNumbers)
{
    expectInsertedAsListed("vectorised");
    expectInsertedAsListed("stock");
}


TEST(clumpInsertion, bringsTheMassOfItsTemplates)
{
    boxOfWater w("fluid none;", periodicBox());
    writeCase(w, listed());
    demCoupling alone(w.box().mesh(), vector(Zero));
    const scalar two = sphereUnion(otherCentres, otherRadii()).volume();
    const scalar alike = 4.0/3.0*constant::mathematical::pi*1e-6;
    const scalar expected = 2500*(3*shape().volume() + 2*two + 2*alike);

    EXPECT_NEAR(sum(phaseOf(w).mass()), expected, 1e-12*expected);
}


TEST(clumpInsertion, aClumpOutsideOfTheBoxIsAnError)
{
    DynamicList<placedClump> clumps(listed());
    clumps[1].centre.z() = 1.2;
    expectHolds(refused(clumps), "1 of the 5 clumps");
}


TEST(clumpInsertion, inTheScriptThatRestartsReadItIsAnError)
{
    const std::string text
    (
        refusal([&]
        {
            boxOfWater w("fluid none;");
            writeCase(w, listed(), "");
            w.writePhysics("fix insertion all insert/clumps file clumps\n");
            demCoupling alone(w.box().mesh(), vector(Zero));
        })
    );
    expectHolds(text, "again at each restart");
    expectHolds(text, "initial script");
}


// Its centre is inside
TEST(clumpInsertion, aClumpThatReachesOutOfTheBoxIsAnError)
{
    DynamicList<placedClump> clumps(listed());
    clumps[1].centre.z() = 0.999;
    expectHolds(refused(clumps), "1 clumps reach out of the grains' box");
}


TEST(clumpInsertion, aTemplateThatIsAbsentIsAnError)
{
    DynamicList<placedClump> clumps(listed());
    clumps[2].kind = "pebble";
    const std::string text(refused(clumps));
    expectHolds(text, "need a template pebble");
    expectHolds(text, "clumpTemplates");
}


TEST(clumpTable, givesBackEveryBit)
{
    const temporaryFolder folder;
    const fileName file(fileName(folder)/"clumps");
    writeClumpTable(file, listed());
    const DynamicList<placedClump> again(readClumpTable(file));

    ASSERT_EQ(again.size(), listed().size());
    forAll(again, i)
    {
        EXPECT_EQ(again[i].kind, listed()[i].kind);
        EXPECT_EQ(again[i].centre, listed()[i].centre);
        EXPECT_EQ(again[i].orientation, listed()[i].orientation);
    }
}


TEST(clumpTable, oneThatIsAbsentCutOrWrongIsAnError)
{
    expectHolds(unreadable(""), "absent or empty");
    expectHolds(unreadable("2 clumps\na 0 0 0 1 0 0 0\n"), "Line 3");
    expectHolds(unreadable("1 clumps\na 0 0 0 1 0 0\n"), "Line 2");
    expectHolds(unreadable("1 clumps\na 0 0 0 1 0 0 0 0\n"), "Line 2");
    expectHolds(unreadable("1 clumps\na 0 0 0 1 0.1 0 0\n"), "of length 1");
    expectHolds(unreadable("clumps\n"), "here -1");
}
