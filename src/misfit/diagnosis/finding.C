// SPDX-License-Identifier: GPL-3.0-or-later
// All that a diagnosis finds, in words.

#include "finding.H"
#include "StringStream.H"

#include <cmath>

Foam::string Foam::misfit::told
(
    const hypothesis& h,
    const wordList& mechanisms
)
{
    if (h.fault)
    {
        return h.fault->told();
    }
    if (h.isOnlyUnknown())
    {
        return "unknown";
    }
    string words;
    for (const label m : h.mechanisms)
    {
        words += (words.empty() ? "" : " and ") + mechanisms[m];
    }
    if (h.unknown)
    {
        words += " and something unknown";
    }
    return words.empty() ? string("none") : words;
}


Foam::word Foam::misfit::phaseOf
(
    const segment& s,
    const vec& y,
    const window& w
)
{
    if (!s.overTime)
    {
        return s.isNumber() ? "number" : "profile";
    }
    const vec v = s.of(y).array() - y[s.first];
    label peak = 0;
    const scalar height = v.cwiseAbs().maxCoeff(&peak);
    label arrival = 0;
    while (arrival < peak && mag(v[arrival]) < 0.1*height)
    {
        ++arrival;
    }
    label end = s.size;
    while (end > peak + 1 && mag(v[end-1] - v[s.size-1]) < 0.1*height)
    {
        --end;
    }

    const scalar middle = 0.5*(w.begin + w.end - 1);
    const label tail = peak + (end - peak)/2;
    return
        middle < arrival - 0.5 ? "before"
      : middle <= peak + 0.5 ? "front"
      : middle < tail ? "body"
      : middle < end ? "tail" : "after";
}


Foam::string Foam::misfit::told
(
    const window& w,
    const stacked& data,
    const vec& misfit
)
{
    const segment& s = data.segments[w.segment];
    const scalar mean =
        misfit.segment(s.first + w.begin, w.end - w.begin).mean();
    const scalar share = 100*mag(mean)/max(s.range(data.y), VSMALL);

    OStringStream os;
    os.precision(3);
    os << s.quantity.c_str() << ' ' << s.name.c_str();
    if (s.hasPlace)
    {
        os << " at (" << s.place.x() << ' ' << s.place.y() << ' '
            << s.place.z() << ')';
    }
    if (!s.isNumber())
    {
        os << ", " << s.x[w.begin] - 0.5*s.span << " to "
            << s.x[w.end - 1] + 0.5*s.span << (s.overTime ? " s" : " m");
    }
    os << ": the simulation is ";
    if (share > 1000)
    {
        os << "more than 1000";
    }
    else
    {
        os << share;
    }
    os << (s.isNumber() ? " % too " : " % of the range too ")
        << (mean > 0 ? "low" : "high") << " (" << mag(w.size) << " sigma)";
    if (!s.isNumber())
    {
        os << ", " << phaseOf(s, data.y, w).c_str();
    }
    return os.str();
}
