// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor that answers late.

#include "lagFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

#include <cmath>

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(lagFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, lagFault, possible, channel);
}
}


void Foam::misfit::lagFault::tell(Ostream& os, const vec& u) const
{
    os << " lags by " << u[0] << " s";
}


Foam::misfit::vec Foam::misfit::lagFault::lagged
(
    const segment& s,
    const vec& f,
    const scalar time
)
{
    vec shown = s.of(f);
    if (time <= 1e-9*s.duration())
    {
        return shown;
    }
    for (label i = 1; i < s.size; ++i)
    {
        const scalar h = s.x[i] - s.x[i-1];
        const scalar before = f[s.first + i - 1];
        const scalar now = f[s.first + i];
        const scalar behind = time*(now - before)/h;
        shown[i] =
            now - behind
          + (shown[i-1] - before + behind)*std::exp(-min(h/time, 700.0));
    }
    return shown;
}


Foam::misfit::faultList Foam::misfit::lagFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    return onlyIf<lagFault>(data->segments[i].overTime, data, i);
}


Foam::List<Foam::misfit::vec> Foam::misfit::lagFault::starts() const
{
    const scalar d = at().duration();
    return {number(0.01*d), number(0.1*d)};
}


Foam::misfit::vec
Foam::misfit::lagFault::operator()(const vec& f, const vec& u) const
{
    vec shown = f;
    at().of(shown) = lagged(at(), f, u[0]);
    return shown;
}
