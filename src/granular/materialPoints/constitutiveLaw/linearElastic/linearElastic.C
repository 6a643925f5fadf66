// SPDX-License-Identifier: GPL-3.0-or-later
// Linear elasticity, for tests and solid blocks.

#include "linearElastic.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
    defineTypeNameAndDebug(linearElastic, 0);
    addToRunTimeSelectionTable(constitutiveLaw, linearElastic, dictionary);
}


Foam::linearElastic::linearElastic(const dictionary& dict)
:
    constitutiveLaw(checked(dict, wordList()))
{}


void Foam::linearElastic::update
(
    pointSet& points,
    const label body,
    const UList<scalar>& dilation,
    const scalar dt
) const
{
    const scalar K = bulkModulus();
    const scalar G = shearModulus();

    for (label i = 0; i < points.size(); ++i)
    {
        if (points.body[i] == body)
        {
            const tensor& L = points.gradient[i];
            symmTensor& stress = points.stress[i];

            stress +=
                dt
               *(
                    turning(L, stress)
                  + K*dilation[i]*symmTensor::I
                  + 2*G*dev(symm(L))
                );
        }
    }
}
