// SPDX-License-Identifier: GPL-3.0-or-later
// The force of the past: of the boundary layer that lags behind a grain's slip.

#include "historyForce.H"

#include "HashSet.H"
#include "Pstream.H"
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
    window_(dict.lookupOrDefault<scalar>("window", 1)),
    interval_(0)
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
    interval_ = interval;
    fall_.clear();
    made_.clear();
    felt_.clear();
    past_.clear();

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
        felt_.append(weight*mean);
    }

    // Those beyond are taken up by the last
    if (felt_.size())
    {
        felt_.last() *= 1 + 1/(std::exp(step) - 1);
    }
}


void Foam::historyForce::follow(const List<locatedGrain>& grains)
{
    labelHashSet here(2*grains.size());
    for (const locatedGrain& grain : grains)
    {
        here.insert(grain.id);
    }

    List<labelList> ids(Pstream::nProcs());
    List<vectorList> numbers(Pstream::nProcs());
    for (const label id : past_.toc())
    {
        if (!here.found(id))
        {
            ids[Pstream::myProcNo()].append(id);
            numbers[Pstream::myProcNo()].append(past_[id]);
            past_.erase(id);
        }
    }
    if (!Pstream::parRun())
    {
        return;
    }

    // Few cross a cut in one interval: all ranks are told of them
    Pstream::gatherList(ids);
    Pstream::scatterList(ids);
    Pstream::gatherList(numbers);
    Pstream::scatterList(numbers);

    const label n = fall_.size() + 1;
    forAll(ids, rank)
    {
        forAll(ids[rank], i)
        {
            if (here.found(ids[rank][i]))
            {
                past_.insert
                (
                    ids[rank][i],
                    vectorList(SubList<vector>(numbers[rank], n, i*n))
                );
            }
        }
    }
}


void Foam::historyForce::begin
(
    const List<locatedGrain>& grains,
    const scalar interval
)
{
    if (active())
    {
        makeExponentials(interval);
        follow(grains);
    }
}


Foam::scalar Foam::historyForce::mass(const grainState& state) const
{
    return
        active() ? strength_*factor(state)*4.0/3*std::sqrt(interval_) : 0;
}


Foam::vector Foam::historyForce::force
(
    const label id,
    const grainState& state
)
{
    if (!active())
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
        sum += felt_[i]*past[i];
    }

    return strength_*factor(state)*sum;
}


Foam::scalar Foam::historyForce::weight(const label intervalsAgo) const
{
    scalar sum = 0;
    forAll(fall_, i)
    {
        sum += felt_[i]*made_[i]*std::pow(fall_[i], intervalsAgo - 1);
    }
    return sum;
}


Foam::dictionary Foam::historyForce::inUse() const
{
    dictionary dict;
    dict.add("strength", strength_);
    if (active())
    {
        dict.add("window", window_);
    }
    return dict;
}
