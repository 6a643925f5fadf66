// SPDX-License-Identifier: GPL-3.0-or-later
// Unit tests: a void fraction that moves with the mean velocity of the grains.

#include "boxOfWater.H"
#include "testNumber.H"

#include <gtest/gtest.h>

using namespace Foam;

namespace
{

const vector velocity(0.3, 0, 0);


testBox slices()
{
    testBox shape;
    shape.cells = labelVector(80, 4, 4);
    return shape;
}


//- Four grains that move along x with the fluid's void fraction that they have: what
//  their velocity alone changes of it
class movingGrains
{
    boxOfWater w_;
    demCoupling coupling_;
    volScalarField voidFraction_;

    static boxOfWater& prepared(boxOfWater& w)
    {
        w.addPhysics("velocity all set 0.3 0 0 units box");
        return w;
    }

public:

    movingGrains(const testBox& shape, const std::string& more = "")
    :
        w_("exchange { interval 50; relaxationTime 1e9; } " + more, shape),
        coupling_(prepared(w_).box().mesh(), hydrostatics(g)),
        voidFraction_
        (
            IOobject("voidFraction", mesh().time().timeName(), mesh()),
            mesh(),
            dimensionedScalar("one", dimless, 1),
            "zeroGradient"
        )
    {
        coupling_.start(w_.water());
        coupling_.moveGrains();
        coupling_.locateGrains();
        coupling_.findVoidFraction();
        voidFraction_.primitiveFieldRef() -= coupling_.solidFraction();
        voidFraction_.correctBoundaryConditions();
    }

    const fvMesh& mesh()
    {
        return w_.box().mesh();
    }

    scalarField solids() const
    {
        return voidFraction_.mesh().V()*coupling_.solidFraction();
    }

    //- Of the volume of the solids in each cell [m3/s]
    scalarField rate(const slidingGate& gate)
    {
        return
           -mesh().V()
           *coupling_.voidFractionRate(voidFraction_, gate, interval)().field();
    }

    scalarField rate()
    {
        return rate(slidingGate(mesh()));
    }

    //- Area of a patch that the solids take [m2]
    scalar solidArea(const word& name)
    {
        const label patch = mesh().boundaryMesh().findPatchID(name);
        return gSum
        (
            mesh().magSf().boundaryField()[patch]
           *(1 - voidFraction_.boundaryField()[patch])
        );
    }

    scalarField x()
    {
        return mesh().C().primitiveField() & vector(1, 0, 0);
    }
};


void expectSpeedOfGrains()
{
    movingGrains grains(slices());
    const scalarField rate(grains.rate());
    const scalar speed = gSum(rate*grains.x())/gSum(grains.solids());

    testNumber("speed of the solid fraction over that of the grains", speed/velocity.x());
    EXPECT_LT(mag(gSum(rate)), 1e-12*gSum(mag(rate)));
    EXPECT_NEAR(speed, velocity.x(), 0.01*velocity.x());
}

} // End anonymous namespace


TEST(solidTransport, movesTheVoidFractionAsFastAsTheGrains)
{
    expectSpeedOfGrains();
}


TEST(ParallelSolidTransport, movesTheVoidFractionAsFastAsTheGrains)
{
    expectSpeedOfGrains();
}


TEST(solidTransport, losesNothingThroughOpenPatchesThatAreNoOutlet)
{
    testBox shape(slices());
    shape.patches.fill("patch");
    shape.span.x() = 0.64;
    movingGrains grains(shape);
    const scalarField rate(grains.rate());

    EXPECT_GT(gSum(mag(rate)), 0);
    EXPECT_LT(mag(gSum(rate)), 1e-12*gSum(mag(rate)));
}


TEST(solidTransport, letsSolidsOutWhereGrainsLeave)
{
    testBox shape(slices());
    shape.patches[1] = "patch";
    shape.span.x() = 0.64;
    movingGrains grains
    (
        shape,
        "LIGGGHTS { outflow (xMax); walls { patches (\".*\"); type 1; } }"
    );

    const scalar through = velocity.x()*grains.solidArea("xMax");
    EXPECT_GT(through, 0);
    // The water at rest has slowed the grains a little
    EXPECT_NEAR(-gSum(grains.rate()), through, 0.01*through);
}


TEST(solidTransport, doesNotPassAShutGate)
{
    movingGrains grains(slices());
    const dictionary closed
    (
        IStringStream
        (
            "point (0.45 0.5 0); normal (1 0 0); direction (0 0 1); speed 1; start 1;"
        )()
    );
    const slidingGate gate(grains.mesh(), closed);
    const scalarField rate(grains.rate(gate));
    const scalarField behind(pos0(0.45 - grains.x()));

    EXPECT_GT(gSum(mag(rate)), 0);
    EXPECT_LT(mag(gSum(behind*rate)), 1e-12*gSum(mag(rate)));
    EXPECT_GT(mag(gSum(behind*grains.rate())), 1e-3*gSum(mag(rate)));
}
