// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor that shows nothing above a value.

#include "saturatedFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(saturatedFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, saturatedFault, possible, channel);
}
}


void Foam::misfit::saturatedFault::tell(Ostream& os, const vec& u) const
{
    os << " is saturated: it shows nothing above " << u[0] << unit().c_str();
}


bool Foam::misfit::saturatedFault::staysAtTop(const segment& s, const vec& y)
{
    label peak = 0;
    const scalar least = s.of(y).maxCoeff(&peak) - 4*noiseOf(s);
    label n = 1;
    for (label i = peak + 1; i < s.size && y[s.first + i] >= least; ++i)
    {
        ++n;
    }
    for (label i = peak - 1; i >= 0 && y[s.first + i] >= least; --i)
    {
        ++n;
    }
    return n > 2;
}


Foam::misfit::faultList Foam::misfit::saturatedFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    const segment& s = data->segments[i];
    return
        onlyIf<saturatedFault>
        (
            staysAtTop(s, data->y) && !isFlat(s, data->y), data, i
        );
}


Foam::List<Foam::misfit::vec> Foam::misfit::saturatedFault::starts() const
{
    return {slight(), number(top() - 0.2*range())};
}


Foam::misfit::vec
Foam::misfit::saturatedFault::operator()(const vec& f, const vec& u) const
{
    vec shown = f;
    at().of(shown) = at().of(f).cwiseMin(u[0]);
    return shown;
}
