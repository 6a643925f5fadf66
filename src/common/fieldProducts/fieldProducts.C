// SPDX-License-Identifier: GPL-3.0-or-later
// Inner products of fields, compiled here with __restrict__ taken away (see
// etc/options.mk) so that they are right where the result is written over a
// temporary operand. OpenFOAM's libraries look these functions up by name when
// they are loaded, and this library comes first: what they compute with such a
// product (fvc::reconstruct among them) is right as well.

#include "volFields.H"
#include "surfaceFields.H"
#include "pointFields.H"

namespace Foam
{

#define instantiateProduct(Type1, Type2, PatchField, GeoMesh)                  \
    template void dot<Type1, Type2, PatchField, GeoMesh>                       \
    (                                                                          \
        GeometricField                                                         \
        <innerProduct<Type1, Type2>::type, PatchField, GeoMesh>&,              \
        const GeometricField<Type1, PatchField, GeoMesh>&,                     \
        const GeometricField<Type2, PatchField, GeoMesh>&                      \
    );

// All whose result is of the type of an operand
#define instantiateProducts(PatchField, GeoMesh)                               \
    instantiateProduct(tensor, vector, PatchField, GeoMesh)                    \
    instantiateProduct(symmTensor, vector, PatchField, GeoMesh)                \
    instantiateProduct(vector, tensor, PatchField, GeoMesh)                    \
    instantiateProduct(vector, symmTensor, PatchField, GeoMesh)                \
    instantiateProduct(tensor, tensor, PatchField, GeoMesh)                    \
    instantiateProduct(tensor, symmTensor, PatchField, GeoMesh)                \
    instantiateProduct(symmTensor, tensor, PatchField, GeoMesh)

instantiateProducts(fvPatchField, volMesh)
instantiateProducts(fvsPatchField, surfaceMesh)
instantiateProducts(pointPatchField, pointMesh)

#undef instantiateProducts
#undef instantiateProduct

} // End namespace Foam
