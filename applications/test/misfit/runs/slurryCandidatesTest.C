// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates of misfitFoam that are transport models of OpenFOAM: what a strength of
// 0 and of 1 makes of water.

#include "caseChange.H"
#include "testMesh.H"
#include "testNumber.H"

#include "IFstream.H"
#include "IStringStream.H"
#include "OSspecific.H"
#include "fixedValueFvPatchFields.H"
#include "fvMatrices.H"
#include "fvmLaplacian.H"
#include "surfaceFields.H"
#include "viscosityModel.H"

#include <gtest/gtest.h>

#include <fstream>

using namespace Foam;

namespace
{

const std::string newtonian = "transportModel Newtonian; nu 1e-6; rho 1000;";

//- As candidates.md has it in a case, k [m2/s] being that of the sheared slurry
std::string yielding(const std::string& k)
{
    return
        "transportModel HerschelBulkley; rho 1000;"
        " HerschelBulkleyCoeffs { nu0 1; tau0 0; k " + k + "; n 1; }";
}

//- How a strength of a slurry changes a case (candidates.md)
const std::string viscousChange = "entry \"water/nu\"; scale 1e-3; offset 1e-6;";

const std::string yieldChange =
    "entry \"water/HerschelBulkleyCoeffs/tau0\"; scale 0.01;";


//- Water on a floor at z = 0, of a depth [m], that slides along x
class layer
{
    testMesh box_;

    autoPtr<volVectorField> U_;

    autoPtr<surfaceScalarField> phi_;

    autoPtr<viscosityModel> water_;

    static testBox shape(const scalar depth)
    {
        testBox box;
        box.span = vector(depth, depth, depth);
        box.cells = labelVector(1, 1, 80);
        box.patches = {"patch", "patch", "patch", "patch", "wall", "patch"};
        return box;
    }

    wordList boundary() const
    {
        wordList types(6, "zeroGradient");
        types[4] = "fixedValue";
        return types;
    }

    //- Let the velocity rise by so much for each metre [1/s]
    void shear(const scalar rate)
    {
        forAll(*U_, cell)
        {
            (*U_)[cell] = vector(rate*box_.mesh().C()[cell].z(), 0, 0);
        }
        U_->correctBoundaryConditions();
        water_->correct();
    }


public:

    //- A change is made in transportProperties: a dictionary's entries and the
    //  strength
    layer
    (
        const scalar depth,
        const std::string& water,
        const std::string& change,
        const scalar strength
    )
    :
        box_(shape(depth))
    {
        const fileName path(box_.folder()/"constant"/"transportProperties");
        mkDir(path.path());
        std::ofstream(path)
            << "FoamFile { version 2.0; format ascii; class dictionary;"
               " object transportProperties; }\nwater { " << water << " }\n";

        const std::string text =
            "file \"constant/transportProperties\"; " + change;
        misfit::caseChange(dictionary(IStringStream(text)()))
            .apply(box_.folder(), strength);

        const fvMesh& mesh = box_.mesh();
        U_.reset
        (
            new volVectorField
            (
                IOobject("U", "0", mesh),
                mesh,
                dimensionedVector("U", dimVelocity, Zero),
                boundary()
            )
        );
        phi_.reset
        (
            new surfaceScalarField
            (
                IOobject("phi", "0", mesh),
                mesh,
                dimensionedScalar("phi", dimVelocity*dimArea, 0)
            )
        );
        water_ = viscosityModel::New
        (
            "nu",
            dictionary(IFstream(path)()).subDict("water"),
            *U_,
            *phi_
        );
    }

    //- Stress over the density [m2/s2] where the velocity rises by so much for
    //  each metre [1/s]
    scalar stress(const scalar rate)
    {
        shear(rate);
        return water_->nu()()[box_.mesh().nCells()/2]*rate;
    }

    //- Velocity [m/s] at each height when it no longer changes, driven along x
    //  [m/s2] with no stress on top
    scalarField slidesDown(const scalar drive)
    {
        const dimensionedVector g("g", dimAcceleration, vector(drive, 0, 0));
        // Hundreds of solutions, none worth a line
        const int level = SolverPerformance<vector>::debug;
        SolverPerformance<vector>::debug = 0;

        // At rest and without a yield stress it would have no viscosity at all
        shear(1);
        scalar change = GREAT;
        for (label i = 0; i < 2000 && change > 1e-9; ++i)
        {
            const vectorField before(U_->primitiveField());
            fvVectorMatrix balance(fvm::laplacian(water_->nu(), *U_) == -g);
            balance.solve();
            water_->correct();
            change =
                max(mag(U_->primitiveField() - before))
               /max(mag(U_->primitiveField()));
        }
        SolverPerformance<vector>::debug = level;
        EXPECT_LE(change, 1e-9);
        return U_->primitiveField().component(vector::X);
    }
};

} // End anonymous namespace


TEST(viscousSlurry, withoutStrengthItIsWaterAndWithOneAsViscousAsStated)
{
    layer none(0.1, newtonian, viscousChange, 0);
    layer half(0.1, newtonian, viscousChange, 0.5);
    layer one(0.1, newtonian, viscousChange, 1);

    EXPECT_NEAR(none.stress(3), 3e-6, 1e-12);
    EXPECT_NEAR(half.stress(3), 3*(0.5e-3 + 1e-6), 1e-12);
    EXPECT_NEAR(one.stress(3), 3*(1e-3 + 1e-6), 1e-12);
}


TEST(yieldingSlurry, withoutStrengthItIsWaterAtAnyRate)
{
    layer none(0.1, yielding("1e-6"), yieldChange, 0);

    for (const scalar rate : {0.01, 1.0, 100.0})
    {
        EXPECT_NEAR(none.stress(rate), 1e-6*rate, 1e-12*rate);
    }
}


TEST(yieldingSlurry, itsStressIsThatOfYieldAndThatOfWater)
{
    layer half(0.1, yielding("1e-6"), yieldChange, 0.5);
    layer one(0.1, yielding("1e-6"), yieldChange, 1);

    for (const scalar rate : {0.1, 1.0, 100.0})
    {
        testNumber("stress over density [m2/s2]", one.stress(rate));
        EXPECT_NEAR(half.stress(rate), 0.005 + 1e-6*rate, 1e-9);
        EXPECT_NEAR(one.stress(rate), 0.01 + 1e-6*rate, 1e-9);
    }
}


TEST(yieldingSlurry, aLayerOnASlopeSlidesAsAPlugOnAShearedFoot)
{
    constexpr scalar depth = 0.01;
    constexpr scalar k = 1e-3;
    constexpr scalar drive = 2;
    layer one(depth, yielding("1e-3"), yieldChange, 1);
    const scalarField U(one.slidesDown(drive));

    // Bingham (1922): sheared where drive (depth - z) is above 0.01 m2/s2
    const scalar foot = depth - 0.01/drive;
    forAll(U, cell)
    {
        const scalar z = min((cell + 0.5)*depth/U.size(), foot);
        const scalar exact = drive/k*(foot*z - 0.5*sqr(z));
        EXPECT_NEAR(U[cell], exact, 0.02*drive/k*0.5*sqr(foot));
    }
    testNumber("speed of the plug [m/s]", U[U.size() - 1]);
}


TEST(yieldingSlurry, withoutStrengthALayerOnASlopeIsShearedThroughout)
{
    constexpr scalar depth = 0.01;
    layer none(depth, yielding("1e-3"), yieldChange, 0);
    const scalarField U(none.slidesDown(2));
    EXPECT_NEAR(U[U.size() - 1], 0.5*2/1e-3*sqr(depth), 0.01*0.1);
}
