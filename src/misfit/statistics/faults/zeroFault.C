// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor whose zero is off.

#include "zeroFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(zeroFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, zeroFault, possible, channel);
}
}


void Foam::misfit::zeroFault::tell(Ostream& os, const vec& u) const
{
    os << "'s zero is off: it reads " << mag(u[0]) << unit().c_str() << " too "
        << (u[0] > 0 ? "high" : "low") << " throughout";
}


Foam::misfit::faultList Foam::misfit::zeroFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    // A number alone that is off by some is off by a share, too
    return onlyIf<zeroFault>(!data->segments[i].isNumber(), data, i);
}


Foam::misfit::vec
Foam::misfit::zeroFault::operator()(const vec& f, const vec& u) const
{
    vec shown = f;
    at().of(shown).array() += u[0];
    return shown;
}
