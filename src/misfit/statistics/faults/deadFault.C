// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor that is dead or stuck.

#include "deadFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(deadFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, deadFault, possible, channel);
}
}


void Foam::misfit::deadFault::tell(Ostream& os, const vec& u) const
{
    // Nought where it is far below its noise
    const scalar shown = mag(u[0]) <= 0.01*at().uncertainty ? 0 : u[0];
    os << " shows " << shown << unit().c_str()
        << " throughout, whatever happens: it is dead or stuck";
}


Foam::misfit::faultList Foam::misfit::deadFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    return onlyIf<deadFault>(isFlat(data->segments[i], data->y), data, i);
}


Foam::List<Foam::misfit::vec> Foam::misfit::deadFault::starts() const
{
    return List<vec>(1, slight());
}


Foam::misfit::vec
Foam::misfit::deadFault::operator()(const vec& f, const vec& u) const
{
    vec shown = f;
    at().of(shown).setConstant(u[0]);
    return shown;
}
