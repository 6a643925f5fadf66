// SPDX-License-Identifier: GPL-3.0-or-later
// A recording in another unit.

#include "unitsFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(unitsFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, unitsFault, possible, channel);
}
}


void Foam::misfit::unitsFault::tell(Ostream& os, const vec& /* u */) const
{
    os << " is in another unit: its values are " << factor_
        << " times what they should be";
}


Foam::misfit::faultList Foam::misfit::unitsFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    // Nothing is nothing in any unit
    const vec& y = data->y;
    const segment& s = data->segments[i];
    faultList faults;
    if (!isFlat(s, y) || mag(s.of(y).mean()) > 3*s.uncertainty)
    {
        for (const scalar factor : {1e-3, 1e3, 0.01, 100., 0.1, 10., -1.})
        {
            faults.append(std::make_shared<const unitsFault>(data, i, factor));
        }
    }
    return faults;
}


Foam::misfit::vec Foam::misfit::unitsFault::noiseScales() const
{
    vec scales = sensorFault::noiseScales();
    at().of(scales).setConstant(max(mag(factor_), 1.0));
    return scales;
}


Foam::misfit::vec
Foam::misfit::unitsFault::operator()(const vec& f, const vec& /* u */) const
{
    vec shown = f;
    at().of(shown) *= factor_;
    return shown;
}
