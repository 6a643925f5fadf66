// SPDX-License-Identifier: GPL-3.0-or-later
// A clock that is early or late.

#include "clockFault.H"
#include "Ostream.H"
#include "addToMemberFunctionSelectionTable.H"

namespace Foam
{
namespace misfit
{
    defineTypeNameAndDebug(clockFault, 0);
    addToMemberFunctionSelectionTable(sensorFault, clockFault, possible, channel);
}
}


void Foam::misfit::clockFault::tell(Ostream& os, const vec& u) const
{
    os << "'s clock is " << mag(u[0]) << " s " << (u[0] > 0 ? "late" : "early");
}


Foam::List<Foam::label> Foam::misfit::clockFault::of
(
    const word& recorder,
    const stacked& data
)
{
    List<label> channels;
    forAll(data.segments, i)
    {
        const segment& s = data.segments[i];
        if (s.overTime && !recorder.empty() && s.recorder == recorder)
        {
            channels.append(i);
        }
    }
    return channels;
}


Foam::misfit::faultList Foam::misfit::clockFault::possible
(
    const recordedPtr& data,
    const label i
)
{
    const segment& s = data->segments[i];
    faultList all;
    if (s.overTime)
    {
        const List<label> together(of(s.recorder, *data));
        if (together.size() > 1 && together.first() == i)
        {
            all.append(std::make_shared<const clockFault>(data, together));
        }
        all.append(std::make_shared<const clockFault>(data, List<label>({i})));
    }
    return all;
}


Foam::word Foam::misfit::clockFault::channel() const
{
    return channels_.size() > 1 ? at().recorder : at().name;
}


Foam::List<Foam::misfit::vec> Foam::misfit::clockFault::starts() const
{
    const scalar d = at().duration();
    return {number(-0.1*d), number(-0.02*d), number(0.02*d), number(0.1*d)};
}


Foam::misfit::vec
Foam::misfit::clockFault::operator()(const vec& f, const vec& u) const
{
    vec shown = f;
    for (const label i : channels_)
    {
        const segment& on = data().segments[i];
        segment late(on);
        late.x.array() += u[0];
        on.of(shown) = across(f, late, on);
    }
    return shown;
}


Foam::misfit::vec Foam::misfit::clockFault::elsewhere
(
    const stacked& other,
    const vec& f,
    const vec& u
) const
{
    // What has the same recorder has its clock, the rest is as it is
    const List<label> same(of(at().recorder, other));
    return
        channels_.size() < 2 || same.empty() ? f
      : clockFault(std::make_shared<const stacked>(other), same)(f, u);
}
