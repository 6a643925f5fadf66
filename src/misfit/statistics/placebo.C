// SPDX-License-Identifier: GPL-3.0-or-later
// What an explanation gains where there is nothing that it could explain.

#include "placebo.H"

#include <algorithm>

namespace
{

using namespace statistics;

//- Each channel moved round by half of its length
vec halfRoundLater(const stacked& data, const vec& v)
{
    vec moved(v.size());
    for (const segment& s : data.segments)
    {
        for (int i = 0; i < s.size; ++i)
        {
            moved[s.first + i] = v[s.first + (i + s.size/2) % s.size];
        }
    }
    return moved;
}


//- Cosine of the angle between two effects; 0 where they are against each other
double likeness(const vec& a, const vec& b)
{
    return std::max(a.dot(b), 0.0)/std::max(a.norm()*b.norm(), tiny);
}

} // End anonymous namespace


double statistics::gain(const sampledModel& m, const hypothesis& h)
{
    const scoring score(m.score());
    const hypothesisFit base(score.base());
    return
        base.score
      - score.withBaseCovariance(h, whitener(base.covariance)).score;
}


statistics::placebo::placebo
(
    const sampledModel& m,
    const hypothesisFit& base,
    const hypothesisFit& best,
    const double lasting
)
{
    const stacked& data = m.data();
    const vec y = data.y;
    const vec& without = base.fit.f;
    sampledModel copy(m);

    copy.record(2*without - y);
    gain = statistics::gain(copy, best.what);

    const vec effect = best.fit.f - without;
    const whitener white(base.covariance);
    moved = likeness(white(effect), white(halfRoundLater(data, effect))) < lasting;
    if (moved)
    {
        copy.record(without + halfRoundLater(data, vec(y - without)));
        gain = std::max(gain, statistics::gain(copy, best.what));
    }
}
