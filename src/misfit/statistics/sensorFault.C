// SPDX-License-Identifier: GPL-3.0-or-later
// What a faulty sensor makes of what it should have shown.

#include "sensorFault.H"
#include "StringStream.H"
#include "units.H"

#include <cmath>
#include <map>
#include <string>

const Foam::Enum<Foam::misfit::sensorFault::kind>
Foam::misfit::sensorFault::names
({
    {kind::lag, "lag"},
    {kind::gain, "gain"},
    {kind::zero, "zero"},
    {kind::drift, "drift"},
    {kind::clock, "clock"},
    {kind::clogged, "clogged"},
    {kind::swapped, "swapped"},
    {kind::misplaced, "misplaced"},
    {kind::units, "units"},
    {kind::dead, "dead"},
    {kind::saturated, "saturated"}
});


bool Foam::misfit::sensorFault::isRegistration(const kind k)
{
    return
        k == kind::clock || k == kind::swapped || k == kind::misplaced
     || k == kind::units;
}


namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- A vector of one or two numbers
vec numbers(std::initializer_list<scalar> list)
{
    vec v(list.size());
    label i = 0;
    for (const scalar n : list)
    {
        v[i++] = n;
    }
    return v;
}


//- A number to be read: three digits, nought where it is far below its noise
scalar threeDigits(const scalar value, const scalar noise)
{
    if (mag(value) <= max(0.01*noise, VSMALL))
    {
        return 0;
    }
    const scalar last =
        std::pow(10.0, std::floor(std::log10(mag(value))) - 2);
    return last*std::round(value/last);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::misfit::sensorFault::range() const
{
    return max(at().range(data_->y), SMALL);
}


Foam::scalar Foam::misfit::sensorFault::top() const
{
    return at().of(data_->y).maxCoeff();
}


Foam::misfit::vec
Foam::misfit::sensorFault::lagged(const vec& f, const scalar time) const
{
    const segment& s = at();
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


Foam::misfit::vec Foam::misfit::sensorFault::across
(
    const vec& f,
    const segment& from,
    const segment& to
) const
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


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::sensorFault::sensorFault
(
    const std::shared_ptr<const stacked>& data,
    const kind k,
    const label segment,
    const label other,
    const scalar factor
)
:
    data_(data),
    kind_(k),
    segment_(segment),
    other_(other),
    factor_(factor)
{}


Foam::misfit::sensorFault::sensorFault
(
    const std::shared_ptr<const stacked>& data,
    const List<label>& recorded
)
:
    sensorFault(data, kind::clock, recorded.first())
{
    recorded_ = recorded;
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::string Foam::misfit::sensorFault::told() const
{
    string words(names[kind_] + " of " + channel());
    if (other_ >= 0)
    {
        words +=
            (kind_ == kind::swapped ? " with " : " towards ")
          + data_->segments[other_].name;
    }
    return words;
}


Foam::string Foam::misfit::sensorFault::told(const vec& unknowns) const
{
    OStringStream os;
    os.precision(7);
    os << channel().c_str();
    const string unit(" " + siUnit(at().quantity));
    const vec u = unknowns.unaryExpr
    (
        [](const scalar v) { return threeDigits(v, 0); }
    );
    switch (kind_)
    {
        case kind::lag:
            os << " lags by " << u[0] << " s";
            break;
        case kind::gain:
            os << " reads " << mag(100*u[0]) << " % too "
                << (u[0] > 0 ? "high" : "low");
            break;
        case kind::zero:
            os << "'s zero is off: it reads " << mag(u[0])
                << unit.c_str() << " too "
                << (u[0] > 0 ? "high" : "low") << " throughout";
            break;
        case kind::drift:
            os << " drifts by " << mag(u[0]) << unit.c_str() << ' '
                << (u[0] > 0 ? "up" : "down") << " over the record";
            break;
        case kind::clock:
            os << "'s clock is " << mag(u[0]) << " s "
                << (u[0] > 0 ? "late" : "early");
            break;
        case kind::clogged:
            os << " is clogged: it lags by " << u[0] << " s and shows "
                << 100*(1 + u[1]) << " % of what is there";
            break;
        case kind::swapped:
            os << " and " << data_->segments[other_].name.c_str()
                << " are exchanged";
            break;
        case kind::misplaced:
            os << " is not at its place but " << 100*u[0]
                << " % of the way to "
                << data_->segments[other_].name.c_str();
            break;
        case kind::units:
            os << " is in another unit: its values are " << factor_
                << " times what they should be";
            break;
        case kind::dead:
            os << " shows " << threeDigits(u[0], at().uncertainty) << unit.c_str()
                << " throughout, whatever happens: it is dead or stuck";
            break;
        case kind::saturated:
            os << " is saturated: it shows nothing above " << u[0]
                << unit.c_str();
            break;
    }
    return os.str();
}


Foam::misfit::vec Foam::misfit::sensorFault::noiseScales() const
{
    vec scales = vec::Ones(data_->size());
    if (kind_ == kind::units)
    {
        at().of(scales).setConstant(max(mag(factor_), 1.0));
    }
    return scales;
}


Foam::label Foam::misfit::sensorFault::size() const
{
    return
        kind_ == kind::clogged ? 2
      : kind_ == kind::swapped || kind_ == kind::units ? 0 : 1;
}


Foam::misfit::vec Foam::misfit::sensorFault::lower() const
{
    // A series with less than a twentieth of its gain is told as dead
    switch (kind_)
    {
        case kind::lag: return numbers({0});
        case kind::gain: return numbers({at().isNumber() ? -1 : -0.95});
        case kind::zero: return numbers({-10*range()});
        case kind::drift: return numbers({-10*range()});
        case kind::clock: return numbers({-0.5*at().duration()});
        case kind::clogged: return numbers({0, -1});
        case kind::misplaced: return numbers({0});
        case kind::dead: return numbers({top() - range() - at().uncertainty});
        case kind::saturated: return numbers({top() - range()});
        default: return vec(0);
    }
}


Foam::misfit::vec Foam::misfit::sensorFault::upper() const
{
    switch (kind_)
    {
        case kind::lag: return numbers({at().duration()});
        case kind::gain: return numbers({9});
        case kind::zero: return numbers({10*range()});
        case kind::drift: return numbers({10*range()});
        case kind::clock: return numbers({0.5*at().duration()});
        case kind::clogged: return numbers({2*at().duration(), 0});
        case kind::misplaced: return numbers({1.5});
        case kind::dead: return numbers({top() + at().uncertainty});
        case kind::saturated: return numbers({top() + 0.05*range()});
        default: return vec(0);
    }
}


Foam::misfit::vec Foam::misfit::sensorFault::slight() const
{
    switch (kind_)
    {
        case kind::dead: return numbers({at().of(data_->y).mean()});
        case kind::saturated: return numbers({top() - 0.05*range()});
        default: return 0.01*upper();
    }
}


Foam::List<Foam::misfit::vec> Foam::misfit::sensorFault::starts() const
{
    const scalar d = at().duration();
    switch (kind_)
    {
        case kind::lag:
            return {numbers({0.01*d}), numbers({0.1*d})};
        case kind::clock:
            return
            {
                numbers({-0.1*d}), numbers({-0.02*d}),
                numbers({0.02*d}), numbers({0.1*d})
            };
        case kind::clogged:
            return {numbers({0.05*d, -0.3}), numbers({0.5*d, -0.05})};
        case kind::misplaced:
            return {numbers({0.3})};
        case kind::dead:
            return {slight()};
        case kind::saturated:
            return {slight(), numbers({top() - 0.2*range()})};
        default:
            return {vec(vec::Zero(size()))};
    }
}


Foam::misfit::vec
Foam::misfit::sensorFault::operator()(const vec& f, const vec& u) const
{
    const segment& s = at();
    vec shown = f;
    auto here = s.of(shown);
    switch (kind_)
    {
        case kind::lag:
            here = lagged(f, u[0]);
            break;
        case kind::gain:
            here *= 1 + u[0];
            break;
        case kind::zero:
            here.array() += u[0];
            break;
        case kind::drift:
            here += u[0]/s.duration()*vec(s.x.array() - s.x[0]);
            break;
        case kind::clock:
        {
            const List<label> only(1, segment_);
            for (const label i : recorded_.empty() ? only : recorded_)
            {
                const segment& on = data_->segments[i];
                segment late(on);
                late.x.array() += u[0];
                on.of(shown) = across(f, late, on);
            }
            break;
        }
        case kind::clogged:
            here = (1 + u[1])*lagged(f, u[0]);
            break;
        case kind::swapped:
        {
            const segment& o = data_->segments[other_];
            here = across(f, o, s);
            o.of(shown) = across(f, s, o);
            break;
        }
        case kind::misplaced:
            here =
                (1 - u[0])*s.of(f)
              + u[0]*across(f, data_->segments[other_], s);
            break;
        case kind::units:
            here *= factor_;
            break;
        case kind::dead:
            here.setConstant(u[0]);
            break;
        case kind::saturated:
            here = here.cwiseMin(u[0]).eval();
            break;
    }
    return shown;
}


namespace
{

//- The channels over time of each recorder
std::map<std::string, List<label>> recorders(const stacked& data)
{
    std::map<std::string, List<label>> channels;
    forAll(data.segments, i)
    {
        const segment& s = data.segments[i];
        if (s.overTime && !s.recorder.empty())
        {
            channels[s.recorder].append(i);
        }
    }
    return channels;
}


//- Standard deviation of the noise of a sample
scalar noiseOf(const segment& s)
{
    return
        s.memory > 0 ? s.uncertainty
      : s.uncertainty*std::sqrt(s.readings.cwiseInverse().mean());
}


//- True if the record shows no more than noise around a constant. One in a unit that
//  is a thousand times too large varies by less than its noise, too, but smoothly:
//  less from one sample to the next than noise does (von Neumann 1941, Ann. Math.
//  Stat. 12:367)
bool isFlat(const segment& s, const vec& y)
{
    if (s.isNumber())
    {
        return false;
    }
    const vec v = s.of(y).array() - s.of(y).mean();
    const vec step = v.tail(s.size - 1) - v.head(s.size - 1);
    const scalar kept =
        s.memory > 0 ? std::exp(-s.duration()/(s.size - 1)/s.memory) : 0;
    return
        v.squaredNorm() <= s.size*sqr(1.5*noiseOf(s))
     && step.squaredNorm() >= (1 - kept)*v.squaredNorm();
}


//- True if the record stays at its highest value, but for noise, for three samples
bool staysAtTop(const segment& s, const vec& y)
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


//- True if a channel that shows y can have such a fault
bool canHave(const sensorFault::kind k, const segment& s, const vec& y)
{
    using kind = sensorFault::kind;
    switch (k)
    {
        case kind::lag:
        case kind::drift:
        case kind::clock:
        case kind::clogged:
            return s.overTime;

        // A number alone that is off by some is off by a share, too
        case kind::zero:
        case kind::swapped:
        case kind::misplaced:
            return !s.isNumber();

        // Nothing is nothing in any unit
        case kind::units:
            return !isFlat(s, y) || mag(s.of(y).mean()) > 3*s.uncertainty;

        case kind::dead:
            return isFlat(s, y);

        case kind::saturated:
            return staysAtTop(s, y) && !isFlat(s, y);

        default:
            return true;
    }
}


//- The other channels with which one can be exchanged, or on whose way it can be
List<label> others(const stacked& data, const sensorFault::kind k, const label i)
{
    const segment& a = data.segments[i];
    List<label> all;
    forAll(data.segments, j)
    {
        const segment& b = data.segments[j];
        const bool alike =
            a.quantity == b.quantity && a.overTime == b.overTime
         && !b.isNumber();
        if
        (
            alike && i != j
         && (k == sensorFault::kind::misplaced || i < j)
        )
        {
            all.append(j);
        }
    }
    return all;
}


//- The faults of that kind that a channel can have
void addFaults
(
    const std::shared_ptr<const stacked>& data,
    const sensorFault::kind k,
    const label i,
    List<sensorFault>& all
)
{
    using kind = sensorFault::kind;
    if (!canHave(k, data->segments[i], data->y))
    {
        return;
    }
    if (k == kind::units)
    {
        for (const scalar f : {1e-3, 1e3, 0.01, 100., 0.1, 10., -1.})
        {
            all.append(sensorFault(data, k, i, -1, f));
        }
    }
    else if (k == kind::swapped || k == kind::misplaced)
    {
        for (const label j : others(*data, k, i))
        {
            all.append(sensorFault(data, k, i, j));
        }
    }
    else
    {
        all.append(sensorFault(data, k, i));
    }
}

} // End anonymous namespace


Foam::misfit::vec Foam::misfit::sensorFault::elsewhere
(
    const stacked& other,
    const vec& f,
    const vec& u
) const
{
    const auto there(recorders(other));
    const auto same = there.find
    (
        recorded_.empty() ? std::string() : std::string(at().recorder)
    );
    return
        same == there.end() ? f
      : sensorFault(std::make_shared<const stacked>(other), same->second)(f, u);
}


Foam::List<Foam::misfit::sensorFault> Foam::misfit::possibleFaults
(
    const stacked& data,
    const List<sensorFault::kind>& kinds
)
{
    const auto kept = std::make_shared<const stacked>(data);
    List<sensorFault> all;
    if (kinds.found(sensorFault::kind::clock))
    {
        for (const auto& recorder : recorders(data))
        {
            if (recorder.second.size() > 1)
            {
                all.append(sensorFault(kept, recorder.second));
            }
        }
    }
    forAll(data.segments, i)
    {
        for (const sensorFault::kind k : kinds)
        {
            addFaults(kept, k, i, all);
        }
    }
    return all;
}
