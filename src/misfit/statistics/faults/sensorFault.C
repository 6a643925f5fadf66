// SPDX-License-Identifier: GPL-3.0-or-later
// What a faulty sensor makes of what it should have shown.

#include "sensorFault.H"
#include "StringStream.H"
#include "units.H"

#include <cmath>

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(sensorFault, 0);
    defineMemberFunctionSelectionTable(sensorFault, possible, channel);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::string Foam::misfit::sensorFault::unit() const
{
    return " " + siUnit(at().quantity);
}


Foam::misfit::vec Foam::misfit::sensorFault::across
(
    const vec& f,
    const segment& from,
    const segment& to
)
{
    vec values(to.size);
    label k = 0;
    for (label i = 0; i < to.size; ++i)
    {
        const scalar x = min(max(to.x[i], from.x[0]), from.x[from.size - 1]);
        while (k + 2 < from.size && from.x[k+1] < x)
        {
            ++k;
        }
        const scalar w = (x - from.x[k])/(from.x[k+1] - from.x[k]);
        values[i] =
            (1 - w)*f[from.first + k] + w*f[from.first + k + 1];
    }
    return values;
}


bool Foam::misfit::sensorFault::isFlat(const segment& s, const vec& y)
{
    if (s.isNumber())
    {
        return false;
    }
    // One in a unit that is a thousand times too large varies by less than its
    // noise, too, but smoothly: less from one sample to the next than noise does
    // (von Neumann 1941, Ann. Math. Stat. 12:367)
    const vec v = s.of(y).array() - s.of(y).mean();
    const vec step = v.tail(s.size - 1) - v.head(s.size - 1);
    const scalar kept =
        s.memory > 0 ? std::exp(-s.duration()/(s.size - 1)/s.memory) : 0;
    return
        v.squaredNorm() <= s.size*sqr(1.5*noiseOf(s))
     && step.squaredNorm() >= (1 - kept)*v.squaredNorm();
}


Foam::scalar Foam::misfit::sensorFault::noiseOf(const segment& s)
{
    return
        s.memory > 0 ? s.uncertainty
      : s.uncertainty*std::sqrt(s.readings.cwiseInverse().mean());
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::wordList Foam::misfit::sensorFault::kinds()
{
    return possiblechannelMemberFunctionTablePtr_->sortedToc();
}


Foam::string Foam::misfit::sensorFault::told() const
{
    return type() + " of " + channel() + partner();
}


Foam::string Foam::misfit::sensorFault::told(const vec& unknowns) const
{
    const vec threeDigits = unknowns.unaryExpr
    (
        [](const scalar v)
        {
            const scalar last =
                std::pow(10.0, std::floor(std::log10(max(mag(v), VSMALL))) - 2);
            return mag(v) <= VSMALL ? 0 : last*std::round(v/last);
        }
    );
    OStringStream os;
    os.precision(7);
    os << channel().c_str();
    tell(os, threeDigits);
    return os.str();
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

Foam::misfit::faultList Foam::misfit::possibleFaults
(
    const stacked& data,
    const wordList& kinds
)
{
    const auto& table = *sensorFault::possiblechannelMemberFunctionTablePtr_;
    const auto kept = std::make_shared<const stacked>(data);
    faultList all;
    forAll(data.segments, i)
    {
        for (const word& kind : kinds)
        {
            all.append(table[kind](kept, i));
        }
    }
    return all;
}
