// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor that is clogged.

#include "cloggedFault.H"
#include "lagFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(cloggedFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, cloggedFault, possible, channel);
}
}


void Foam::misfit::cloggedFault::tell(Ostream& os, const vec& u) const
{
    os << " is clogged: it lags by " << u[0] << " s and shows "
        << 100*(1 + u[1]) << " % of what is there";
}


Foam::misfit::faultList Foam::misfit::cloggedFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    return onlyIf<cloggedFault>(data->segments[i].overTime, data, i);
}


Foam::List<Foam::misfit::vec> Foam::misfit::cloggedFault::starts() const
{
    const scalar d = at().duration();
    return {both(0.05*d, -0.3), both(0.5*d, -0.05)};
}


Foam::misfit::vec
Foam::misfit::cloggedFault::operator()(const vec& f, const vec& u) const
{
    vec shown = f;
    at().of(shown) = (1 + u[1])*lagFault::lagged(at(), f, u[0]);
    return shown;
}
