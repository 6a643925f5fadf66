// SPDX-License-Identifier: GPL-3.0-or-later
// What a faulty sensor makes of what it should have shown.

#include "faultKinds.H"

#include <stdexcept>

namespace
{

using namespace statistics;

const faultRow& rowOf(const faultKind kind)
{
    return faultTable()[int(kind)];
}


//- The channels that a fault shows in
std::vector<int> channelsOf(const sensorFault& fault, const stacked& data)
{
    if (fault.ofRecorder)
    {
        return recordedBy(fault.channel, fault.experiment, data);
    }
    std::vector<int> all;
    for (int i = 0; i < count(data.segments); ++i)
    {
        const std::string& name = data.segments[i].name;
        const bool exchanged =
            fault.kind == faultKind::swapped && name == fault.partner;
        if (name == fault.channel || exchanged)
        {
            all.push_back(i);
        }
    }
    return all;
}


//- The other channel of two; the same one of a fault that has no other
const segment& otherThan
(
    const segment& s,
    const sensorFault& fault,
    const stacked& data
)
{
    const std::string& name =
        s.name == fault.channel ? fault.partner : fault.channel;
    for (const segment& other : data.segments)
    {
        if (other.name == name)
        {
            return other;
        }
    }
    return s;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

bool statistics::sensorFault::isRegistration() const
{
    return
        kind == faultKind::clock || kind == faultKind::misplaced
     || kind == faultKind::swapped || kind == faultKind::units;
}


bool statistics::sensorFault::operator==(const sensorFault& other) const
{
    return
        kind == other.kind && channel == other.channel
     && partner == other.partner && ofRecorder == other.ofRecorder
     && experiment == other.experiment;
}


bool statistics::sensorFault::blamesSame(const sensorFault& other) const
{
    const bool exchanged =
        kind == faultKind::swapped || other.kind == faultKind::swapped;
    return
        exchanged
      ? *this == other : channel == other.channel && experiment == other.experiment;
}


statistics::vec statistics::sensorFault::operator()
(
    const stacked& data,
    const vec& f,
    const vec& unknowns
) const
{
    vec reading = f;
    for (const int i : channelsOf(*this, data))
    {
        const segment& s = data.segments[i];
        s.of(reading) =
            rowOf(kind).reading(*this, s, otherThan(s, *this, data), f, unknowns);
    }
    return reading;
}


statistics::vec statistics::sensorFault::uncomputed
(
    const stacked& data,
    const vec& unknowns
) const
{
    vec share = vec::Zero(data.size());
    if (kind == faultKind::clock)
    {
        for (const int i : channelsOf(*this, data))
        {
            const segment& s = data.segments[i];
            const vec from = s.x.array() - unknowns[0];
            const vec before = s.x[0] - from.array();
            const vec after = from.array() - s.x[s.size - 1];
            const double spacing = s.duration()/std::max(s.size - 1, 1);
            s.of(share) = (before.cwiseMax(after)/spacing).cwiseMax(0).cwiseMin(1);
        }
    }
    return share;
}


statistics::vec statistics::sensorFault::elsewhere
(
    const stacked& other,
    const vec& f,
    const vec& unknowns
) const
{
    return ofRecorder ? (*this)(other, f, unknowns) : f;
}


statistics::vec
statistics::sensorFault::noiseScales(const stacked& data) const
{
    vec scales = vec::Ones(data.size());
    if (kind == faultKind::units)
    {
        for (const int i : channelsOf(*this, data))
        {
            data.segments[i].of(scales).setConstant
            (
                std::max(std::abs(factor), 1.0)
            );
        }
    }
    return scales;
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

std::string statistics::nameOf(const faultKind kind)
{
    return rowOf(kind).name;
}


std::vector<std::string> statistics::faultNames()
{
    std::vector<std::string> names;
    for (const faultRow& row : faultTable())
    {
        names.push_back(row.name);
    }
    return names;
}


statistics::faultKind statistics::faultNamed(const std::string& name)
{
    for (int i = 0; i < count(faultTable()); ++i)
    {
        if (name == faultTable()[i].name)
        {
            return faultKind(i);
        }
    }
    throw std::invalid_argument("no fault of a sensor is called " + name);
}


std::vector<statistics::sensorFault> statistics::possibleFaults
(
    const stacked& data,
    const std::vector<faultKind>& kinds
)
{
    std::vector<sensorFault> all;
    for (const segment& s : data.segments)
    {
        for (const faultKind kind : kinds)
        {
            for (const sensorFault& fault : rowOf(kind).possible(data, s))
            {
                all.push_back(fault);
            }
        }
    }
    return all;
}
