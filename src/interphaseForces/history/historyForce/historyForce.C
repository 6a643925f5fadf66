// SPDX-License-Identifier: GPL-3.0-or-later
// The force of the past: of the boundary layer that lags behind a grain's slip.

#include "historyForce.H"

#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "closure.H"
#include "foamCompatibility.H"
#include "mathematicalConstants.H"

#include <cmath>

namespace
{

//- Distance of the exponentials in the logarithm of x: to 5e-4 of the kernel
constexpr Foam::scalar step = 0.6;

//- The file of the past, in the folder of the grains' state
const Foam::word fileOfPast("history");

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


bool Foam::historyForce::write(const fileName& folder) const
{
    if (!isOn())
    {
        return true;
    }

    DynamicList<label> ourIds;
    DynamicList<vector> ourNumbers;
    for (const label id : past_.sortedToc())
    {
        ourIds.append(id);
        ourNumbers.append(past_[id]);
    }
    List<labelList> ids(Pstream::nProcs());
    List<vectorList> numbers(Pstream::nProcs());
    ids[Pstream::myProcNo()].transfer(ourIds);
    numbers[Pstream::myProcNo()].transfer(ourNumbers);
    Pstream::gatherList(ids);
    Pstream::gatherList(numbers);
    if (!Pstream::master())
    {
        return true;
    }

    const fileName aside(folder/fileOfPast + ".incomplete");
    {
        OFstream os(aside, IOstream::BINARY);
        os << scalarList({interval_, window_}) << ids << numbers;
        os.flush();
        if (!os.good())
        {
            return false;
        }
    }
    return mv(aside, folder/fileOfPast);
}


void Foam::historyForce::read(const fileName& folder)
{
    if (!isOn())
    {
        return;
    }

    // One rank knows all of it; follow() brings it to the others
    bool there = true;
    if (Pstream::master())
    {
        there = isFile(folder/fileOfPast, false);
        if (there)
        {
            IFstream is(folder/fileOfPast, IOstream::BINARY);
            scalarList times;
            List<labelList> ids;
            List<vectorList> numbers;
            is >> times >> ids >> numbers;
            readInterval_ = times[0];
            there = times[1] == window_;
            forAll(ids, rank)
            {
                const label n = there ? ids[rank].size() : 0;
                for (label i = 0; i < n; ++i)
                {
                    const label width = numbers[rank].size()/n;
                    past_.insert
                    (
                        ids[rank][i],
                        vectorList
                        (
                            SubList<vector>(numbers[rank], width, i*width)
                        )
                    );
                }
            }
        }
    }
    compatibility::broadcast(readInterval_);
    if (!returnReduce(there, andOp<bool>()))
    {
        Info<< "History force: no past of this window is in " << folder
            << "; it starts again from zero" << endl;
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
