// SPDX-License-Identifier: GPL-3.0-or-later
// Products of fields whose result is written over a temporary operand, as the
// compiler at hand and OpenFOAM's libraries make them, and the check of the
// mesh that depends on them.

#include "reconstructionCheck.H"
#include "terminalOutput.H"
#include "testMesh.H"

#include "Random.H"
#include "fvcReconstruct.H"
#include "pointFields.H"
#include "surfaceFields.H"
#include "transformField.H"
#include "volFields.H"

#include <gtest/gtest.h>

#include <algorithm>

using namespace Foam;

namespace Foam
{
namespace fvc
{
    // What libfiniteVolume holds, not an instance of this program
    extern template tmp<GeometricField<vector, fvPatchField, volMesh>>
    reconstruct<scalar>
    (
        const GeometricField<scalar, fvsPatchField, surfaceMesh>&
    );
}
}

namespace
{

template<class Type>
Type random(Random& numbers)
{
    Type value;
    for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
    {
        value[d] = numbers.sample01<scalar>();
    }
    return value;
}


template<class Type>
Field<Type> randomField(const label n)
{
    Random numbers(n + pTraits<Type>::nComponents);
    Field<Type> f(n);
    std::generate(f.begin(), f.end(), [&]{ return random<Type>(numbers); });
    return f;
}


template<class Type, template<class> class PatchField, class GeoMesh>
using meshField = GeometricField<Type, PatchField, GeoMesh>;


template<class Type, template<class> class PatchField, class GeoMesh>
tmp<meshField<Type, PatchField, GeoMesh>> randomField
(
    const word& name,
    const typename GeoMesh::Mesh& mesh
)
{
    auto f = tmp<meshField<Type, PatchField, GeoMesh>>::New
    (
        IOobject(name, "0", mesh.thisDb()),
        mesh,
        dimensioned<Type>("zero", dimless, Zero)
    );
    f.ref().primitiveFieldRef() =
        randomField<Type>(f().primitiveField().size());
    return f;
}


//- A box whose cells are skewed: no axis is along a face's normal
struct skewBox
{
    testMesh box;

    explicit skewBox(const testBox& shape = testBox())
    :
        box(shape)
    {
        pointField points(box.mesh().points());
        for (point& p : points)
        {
            p.x() += 0.3*p.y();
            if (shape.patches[4] != "empty")
            {
                p += vector(0.15*p.z(), 0.1*p.z(), 0.2*p.x());
            }
        }
        box.mesh().movePoints(points);
    }

    const fvMesh& mesh()
    {
        return box.mesh();
    }
};


//- The largest difference between f(a, b), a or b being temporary or not, and
//  the product of element after element
template<class A, class B>
scalar worst(const Field<A>& a, const Field<B>& b)
{
    typedef typename innerProduct<A, B>::type Result;

    Field<Result> right(a.size());
    forAll(a, i)
    {
        right[i] = a[i] & b[i];
    }

    const auto off = [&](const tmp<Field<Result>>& product)
    {
        return max(mag(product() - right));
    };
    const auto copyA = [&]{ return tmp<Field<A>>::New(a); };
    const auto copyB = [&]{ return tmp<Field<B>>::New(b); };

    return max
    (
        max(off(a & b), off(a & copyB())),
        max(off(copyA() & b), off(copyA() & copyB()))
    );
}


template<class A, class B, template<class> class PatchField, class GeoMesh>
scalar worst(const typename GeoMesh::Mesh& mesh)
{
    typedef meshField<A, PatchField, GeoMesh> fieldA;
    typedef meshField<B, PatchField, GeoMesh> fieldB;

    const auto a = [&]{ return randomField<A, PatchField, GeoMesh>("a", mesh); };
    const auto b = [&]{ return randomField<B, PatchField, GeoMesh>("b", mesh); };

    const fieldA keptA(a());
    const fieldB keptB(b());
    Field<typename innerProduct<A, B>::type> right(keptA.size());
    forAll(right, i)
    {
        right[i] = keptA[i] & keptB[i];
    }

    const auto off = [&](const auto& product)
    {
        return max(mag(product().primitiveField() - right));
    };

    return max
    (
        max(off(keptA & keptB), off(keptA & b())),
        max(off(a() & keptB), off(a() & b()))
    );
}


template<template<class> class PatchField, class GeoMesh>
void expectRight(const typename GeoMesh::Mesh& mesh)
{
    EXPECT_LT((worst<tensor, vector, PatchField, GeoMesh>(mesh)), 1e-15);
    EXPECT_LT((worst<symmTensor, vector, PatchField, GeoMesh>(mesh)), 1e-15);
    EXPECT_LT((worst<vector, tensor, PatchField, GeoMesh>(mesh)), 1e-15);
    EXPECT_LT((worst<vector, symmTensor, PatchField, GeoMesh>(mesh)), 1e-15);
    EXPECT_LT((worst<tensor, tensor, PatchField, GeoMesh>(mesh)), 1e-15);
    EXPECT_LT((worst<tensor, symmTensor, PatchField, GeoMesh>(mesh)), 1e-15);
    EXPECT_LT((worst<symmTensor, tensor, PatchField, GeoMesh>(mesh)), 1e-15);
}


testBox shaped(const word& zPatches, const labelVector& cells)
{
    testBox b;
    b.cells = cells;
    b.patches[4] = b.patches[5] = zPatches;
    return b;
}


label wrongCells(const fvMesh& mesh)
{
    return reconstructionErrorOf(mesh).nCells;
}

} // End anonymous namespace


TEST(FieldProducts, areRightWhereTheResultIsWrittenOverATemporaryOperand)
{
    for (const label n : {1, 3, 64, 1001})
    {
        const vectorField v(randomField<vector>(n));
        const tensorField t(randomField<tensor>(n));
        const symmTensorField s(randomField<symmTensor>(n));

        EXPECT_LT(worst(t, v), 1e-15) << n;
        EXPECT_LT(worst(v, t), 1e-15) << n;
        EXPECT_LT(worst(s, v), 1e-15) << n;
        EXPECT_LT(worst(v, s), 1e-15) << n;
        EXPECT_LT(worst(t, t), 1e-15) << n;
        EXPECT_LT(worst(t, s), 1e-15) << n;
        EXPECT_LT(worst(s, t), 1e-15) << n;
    }
}


TEST(FieldProducts, ofOneFieldAreRightWhereWrittenOverATemporary)
{
    const label n = 1001;
    const vectorField v(randomField<vector>(n));
    const vectorField w(SubField<vector>(randomField<vector>(2*n), n));
    const tensorField t(randomField<tensor>(n));
    const symmTensorField s(randomField<symmTensor>(n));
    const auto temporary = [](const auto& f)
    {
        return tmp<typename std::decay<decltype(f)>::type>::New(f);
    };

    const vectorField turned(transform(t, temporary(v)));
    const vectorField cross(v ^ temporary(w)), cross2(temporary(v) ^ w);
    const tensorField inverse(inv(temporary(t)));
    const tensorField deviator(dev2(temporary(t))), skewed(skew(temporary(t)));
    const symmTensorField squared(innerSqr(temporary(s)));

    forAll(v, i)
    {
        EXPECT_LT(mag(turned[i] - transform(t[i], v[i])), 1e-15);
        EXPECT_LT(mag(cross[i] - (v[i] ^ w[i])), 1e-15);
        EXPECT_LT(mag(cross2[i] - (v[i] ^ w[i])), 1e-15);
        EXPECT_LT(mag(inverse[i] - inv(t[i])), 1e-12*mag(inverse[i]));
        EXPECT_LT(mag(deviator[i] - dev2(t[i])), 1e-15);
        EXPECT_LT(mag(skewed[i] - skew(t[i])), 1e-15);
        EXPECT_LT(mag(squared[i] - innerSqr(s[i])), 1e-15);
    }
}


TEST(FieldProducts, onAMeshAreRightWhereTheResultIsWrittenOverATemporaryOperand)
{
    testMesh box;
    expectRight<fvPatchField, volMesh>(box.mesh());
    expectRight<fvsPatchField, surfaceMesh>(box.mesh());
    expectRight<pointPatchField, pointMesh>(pointMesh::New(box.mesh()));
}


TEST(FieldProducts, giveAUniformVelocityBackFromItsFluxOnASkewedMesh)
{
    skewBox skew;
    const vector u(1, 2, 3);
    const surfaceScalarField flux
    (
        dimensionedVector("u", dimVelocity, u) & skew.mesh().Sf()
    );
    const volVectorField back(fvc::reconstruct(flux));

    EXPECT_LT(max(mag(back.primitiveField() - u)), 1e-13);
}


TEST(ReconstructionCheck, findsNothingWrongOnAnyKindOfMesh)
{
    testMesh box;
    EXPECT_EQ(wrongCells(box.mesh()), 0);

    skewBox skew;
    EXPECT_EQ(wrongCells(skew.mesh()), 0) << "skewed";

    skewBox plane(shaped("empty", labelVector(6, 5, 1)));
    EXPECT_EQ(wrongCells(plane.mesh()), 0) << "two-dimensional";

    testMesh repeated(shaped("cyclic", labelVector(3, 4, 5)));
    EXPECT_EQ(wrongCells(repeated.mesh()), 0) << "cyclic";

    testMesh mirrored(shaped("symmetryPlane", labelVector(3, 4, 5)));
    EXPECT_EQ(wrongCells(mirrored.mesh()), 0) << "symmetryPlane";

    testBox flat;
    flat.span = vector(1, 1, 1e-4);
    testMesh thin(flat);
    EXPECT_EQ(wrongCells(thin.mesh()), 0) << "cells of 1:10,000";
}


TEST(ReconstructionCheck, findsTheCellsWhereNoVelocityComesBack)
{
    testMesh box;
    pointField points(box.mesh().points());
    for (point& p : points)
    {
        // The uppermost layer has no thickness
        p.z() = min(p.z(), scalar(0.75));
    }
    box.mesh().movePoints(points);

    const reconstructionError error(reconstructionErrorOf(box.mesh()));
    EXPECT_EQ(error.nCells, 16);
    // Releases regularise a cell without thickness differently: 0.6 and more
    EXPECT_GT(error.largest, 0.1);
    EXPECT_DOUBLE_EQ(error.at.z(), 0.75);

    // And stops there, with what to do
    const std::string output(refusal([&]{ checkReconstruction(box.mesh()); }));
    EXPECT_NE(output.find("checkMesh"), std::string::npos) << output;
}


TEST(ParallelReconstructionCheck, allRanksKnowTheWorstCellOfOne)
{
    testBox sliced;
    sliced.cut = 2;
    testMesh box(sliced);
    pointField points(box.mesh().points());
    for (point& p : points)
    {
        p.z() = min(p.z(), scalar(0.75));
    }
    box.mesh().movePoints(points);

    const reconstructionError error(reconstructionErrorOf(box.mesh()));
    EXPECT_EQ(error.nCells, 16);
    EXPECT_DOUBLE_EQ(error.at.z(), 0.75);
}
