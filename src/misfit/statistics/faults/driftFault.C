// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor whose zero drifts.

#include "driftFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(driftFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, driftFault, possible, channel);
}
}


void Foam::misfit::driftFault::tell(Ostream& os, const vec& u) const
{
    os << " drifts by " << mag(u[0]) << unit().c_str() << ' '
        << (u[0] > 0 ? "up" : "down") << " over the record";
}


Foam::misfit::faultList Foam::misfit::driftFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    return onlyIf<driftFault>(data->segments[i].overTime, data, i);
}


Foam::misfit::vec
Foam::misfit::driftFault::operator()(const vec& f, const vec& u) const
{
    const segment& s = at();
    vec shown = f;
    s.of(shown) += u[0]/s.duration()*vec(s.x.array() - s.x[0]);
    return shown;
}
