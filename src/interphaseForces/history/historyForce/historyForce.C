// SPDX-License-Identifier: GPL-3.0-or-later
// The force of the past: of the boundary layer that lags behind a grain's slip.

#include "historyForce.H"

#include "closure.H"
#include "mathematicalConstants.H"

#include <cmath>

namespace
{

//- Distance of the exponentials in the logarithm of x: to 5e-4 of the kernel
constexpr Foam::scalar step = 0.6;

//- Basset's factor, 3/2 d^2 sqrt(pi rho mu) [kg/sqrt(s)]
Foam::scalar factor(const Foam::grainState& state)
{
    return
        1.5*Foam::sqr(state.d)
       *std::sqrt(Foam::constant::mathematical::pi*state.rho*state.mu);
}

} // End anonymous namespace


Foam::historyForce::historyForce(const dictionary& dict)
:
    strength_(closure::strength(dict)),
    window_(dict.getOrDefault<scalar>("window", 1)),
    interval_(0),
    readInterval_(0)
{
    keywords::check(dict, {"strength", "window"});

    if (!(window_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "window " << window_ << " s of the history force must be above"
            << " zero." << exit(FatalIOError);
    }
}


void Foam::historyForce::makeExponentials(const scalar interval)
{
    if (interval == interval_)
    {
        return;
    }
    // What was read waits for its exponentials
    const bool isRead = interval_ == 0 && readInterval_ > 0;
    const bool fits = mag(readInterval_ - interval) < 1e-9*interval;
    if (isRead && !fits)
    {
        Info<< "History force: its past is of an exchange interval of "
            << readInterval_ << " s, which is now " << interval
            << " s; it starts again from zero" << endl;
    }
    if (!isRead || !fits)
    {
        past_.clear();
    }
    interval_ = interval;
    fall_.clear();
    made_.clear();
    weights_.clear();

    // Decay times from a small part of the interval to ten windows
    const scalar last = -0.5*std::log(10*window_);
    for (scalar y = -0.5*std::log(interval/1000); y > last; y -= step)
    {
        const scalar decay = std::exp(-2*y);
        const scalar fall = std::exp(-interval/decay);
        const scalar mean = decay/interval*(1 - fall);
        const scalar weight =
            2*step*std::exp(y)/std::sqrt(constant::mathematical::pi);

        fall_.append(fall);
        made_.append(mean);
        weights_.append(weight*mean);
    }

    // Those beyond are taken up by the last
    if (weights_.size())
    {
        weights_.last() *= 1 + 1/(std::exp(step) - 1);
    }
}


void Foam::historyForce::begin
(
    const List<locatedGrain>& grains,
    const scalar interval
)
{
    setInterval(interval);
    if (isOn())
    {
        follow(grains);
    }
}


Foam::scalar Foam::historyForce::mass(const grainState& state) const
{
    return
        isOn() ? strength_*factor(state)*4.0/3*std::sqrt(interval_) : 0;
}


Foam::vector Foam::historyForce::force
(
    const label id,
    const grainState& state
)
{
    if (!isOn())
    {
        return vector::zero;
    }

    const label n = fall_.size();
    if (!past_.found(id))
    {
        vectorList none(n + 1, vector::zero);
        none[n] = state.slip;
        past_.insert(id, none);
        return vector::zero;
    }

    vectorList& past = past_[id];
    const vector change(state.slip - past[n]);
    past[n] = state.slip;

    vector sum(Zero);
    for (label i = 0; i < n; ++i)
    {
        past[i] = fall_[i]*past[i] + made_[i]*change;
        sum += weights_[i]*past[i];
    }

    return strength_*factor(state)*sum;
}


Foam::scalar Foam::historyForce::weight(const label intervalsAgo) const
{
    scalar sum = 0;
    forAll(fall_, i)
    {
        sum += weights_[i]*made_[i]*std::pow(fall_[i], intervalsAgo - 1);
    }
    return sum;
}


Foam::dictionary Foam::historyForce::activePhysics() const
{
    dictionary dict;
    dict.add("strength", strength_);
    if (isOn())
    {
        dict.add("window", window_);
    }
    return dict;
}
