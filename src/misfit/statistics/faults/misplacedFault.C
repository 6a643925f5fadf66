// SPDX-License-Identifier: GPL-3.0-or-later
// A sensor that is not where it is said to be.

#include "misplacedFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(misplacedFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, misplacedFault, possible, channel);
}
}


void Foam::misfit::misplacedFault::tell(Ostream& os, const vec& u) const
{
    os << " is not at its place but " << 100*u[0] << " % of the way to "
        << other().name.c_str();
}


Foam::string Foam::misfit::misplacedFault::partner() const
{
    return " towards " + other().name;
}


Foam::misfit::faultList Foam::misfit::misplacedFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    faultList all;
    for (const label other : alike(*data, i))
    {
        all.append(std::make_shared<const misplacedFault>(data, i, other));
    }
    return all;
}


Foam::List<Foam::misfit::vec> Foam::misfit::misplacedFault::starts() const
{
    return List<vec>(1, number(0.3));
}


Foam::misfit::vec
Foam::misfit::misplacedFault::operator()(const vec& f, const vec& u) const
{
    vec shown = f;
    at().of(shown) = (1 - u[0])*at().of(f) + u[0]*across(f, other(), at());
    return shown;
}
