// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor that shows too much or too little by a share.

#include "gainFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(gainFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, gainFault, possible, channel);
}
}


void Foam::misfit::gainFault::tell(Ostream& os, const vec& u) const
{
    os << " reads " << mag(100*u[0]) << " % too " << (u[0] > 0 ? "high" : "low");
}


Foam::misfit::faultList Foam::misfit::gainFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    return onlyIf<gainFault>(true, data, i);
}


Foam::misfit::vec
Foam::misfit::gainFault::operator()(const vec& f, const vec& u) const
{
    vec shown = f;
    at().of(shown) *= 1 + u[0];
    return shown;
}
