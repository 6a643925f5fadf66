// SPDX-License-Identifier: GPL-3.0-or-later
// Two channels that are exchanged.

#include "swappedFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(swappedFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, swappedFault, possible, channel);
}
}


void Foam::misfit::swappedFault::tell(Ostream& os, const vec& /* u */) const
{
    os << " and " << other().name.c_str() << " are exchanged";
}


Foam::string Foam::misfit::swappedFault::partner() const
{
    return " with " + other().name;
}


Foam::misfit::faultList Foam::misfit::swappedFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    faultList all;
    for (const label other : alike(*data, i))
    {
        if (i < other)
        {
            all.append(std::make_shared<const swappedFault>(data, i, other));
        }
    }
    return all;
}


Foam::misfit::vec
Foam::misfit::swappedFault::operator()(const vec& f, const vec& /* u */) const
{
    vec shown = f;
    at().of(shown) = across(f, other(), at());
    other().of(shown) = across(f, at(), other());
    return shown;
}
