// SPDX-License-Identifier: GPL-3.0-or-later
// Stands for the solver: runs of the surge in closed form.

#include "worldSampler.H"

namespace
{

Foam::misfit::vec joined
(
    const Foam::misfit::vec& a,
    const Foam::misfit::vec& b
)
{
    Foam::misfit::vec both(a.size() + b.size());
    both << a, b;
    return both;
}

} // End anonymous namespace


Foam::misfit::stacked Foam::misfit::worldSampler::validation() const
{
    stacked s;
    s.segments = std::vector<segment>({world_.data.segments[2]});
    s.segments[0].first = 0;
    s.y = world_.data.segments[2].of(world_.data.y);
    return s;
}


bool Foam::misfit::worldSampler::isBetween(const scalar strength)
{
    return strength != 0 && strength != 0.5 && strength != 1;
}


bool Foam::misfit::worldSampler::isBetween(const runState& state)
{
    forAllConstIters(state.strengths, strength)
    {
        if (isBetween(*strength))
        {
            return true;
        }
    }
    return false;
}


Foam::misfit::vec
Foam::misfit::worldSampler::variables(const runState& state) const
{
    vec x = vec::Zero(world_.bounds.mean.size());
    x[0] = state.parameters.lookup("release", 0);
    x[1] = state.parameters.lookup("friction", 0);
    for (label m = 0; m < world::nMechanisms; ++m)
    {
        const scalar strength =
            state.strengths.lookup(world::mechanism(m), 0);
        x[world::nParameters + m] =
            m == idle_ && isBetween(strength) ? 0 : strength;
    }
    if (twins_)
    {
        scalar& second = x[world::nParameters + 1];
        x[world::nParameters] += second;
        second = 0;
    }
    return x;
}


Foam::misfit::vec Foam::misfit::worldSampler::simulated
(
    const vec& x,
    const word& experiment
) const
{
    vec y = x;
    y[0] -= experiment == "A" ? 0 : 0.3;
    return world_(y);
}


bool Foam::misfit::worldSampler::fails(const runState& state)
{
    if (state.experiment == "A" && isBetween(state))
    {
        between_.insert(describe(state));
        if (between_.size() > betweenAllowed_)
        {
            return true;
        }
    }
    return
        (state.experiment == failing_ && state.strengths.size())
     || state.experiment == failingAlways_
     || state.replicate == failingReplicate_
     || (
            failsFiner_ && !state.isBase()
         && (failsFinerIn_.empty() || failsFinerIn_ == state.experiment)
        )
     || (
            crashing_ >= 0
         && variables(state)[world::nParameters + crashing_] > 0
        );
}


Foam::misfit::samples Foam::misfit::worldSampler::run(const runState& state)
{
    samples s;
    if (fails(state))
    {
        s.failure = "floating point exception";
        return s;
    }
    const vec f =
        (1 + replicateChanges_*state.replicate)
       *(1 + (state.isBase() ? 0 : finerChanges_))
       *drawn(state.experiment, state.replicate)
       *simulated(variables(state), state.experiment);
    if (state.experiment == "A")
    {
        std::vector<int> keep;
        world_.data.without(2, keep);
        s.calibration = f(keep);
        if (gaugeBeside_)
        {
            const segment& beside = data_[0].calibration.segments[1];
            s.calibration = joined(s.calibration, beside.of(s.calibration));
        }
        if (data_[0].validation.size())
        {
            s.validation =
                world_.data.segments[2].of(f).head(data_[0].validation.size());
        }
    }
    else
    {
        s.of(data_[1].use) = f;
    }
    return s;
}


Foam::misfit::worldSampler::worldSampler
(
    const vec& x,
    const label seed,
    const vec& added,
    const scalar bend
)
:
    world_(20)
{
    std::mt19937 generator(seed);
    for (const word& e : wordList({"A", "B"}))
    {
        vec y = x;
        y[0] -= e == "B" ? 0.3 : 0;
        world_.data.y = world_(y, bend) + world_.noise(generator);
        if (e == "A" && added.size())
        {
            world_.data.y += added;
        }
        std::vector<int> keep;
        observation o;
        o.experiment = e;
        o.use = e == "A" ? purpose::calibration : purpose::validation;
        if (e == "A")
        {
            o.calibration = world_.data.without(2, keep);
            o.validation = validation();
        }
        else
        {
            o.validation = world_.data;
        }
        data_.append(o);
    }
}


void Foam::misfit::worldSampler::mislabel(const scalar factor)
{
    stacked& calibration = data_[0].calibration;
    calibration.segments[0].of(calibration.y) *= factor;
}


void Foam::misfit::worldSampler::mislabelHeldOut(const scalar factor)
{
    data_[0].validation.y *= factor;
}


void Foam::misfit::worldSampler::makeTwins()
{
    twins_ = true;
}


void Foam::misfit::worldSampler::idleBetween(const label mechanism)
{
    idle_ = mechanism;
}


void Foam::misfit::worldSampler::crashWith(const label mechanism)
{
    crashing_ = mechanism;
}


void Foam::misfit::worldSampler::failBetween(const label allowed)
{
    betweenAllowed_ = allowed;
}


void Foam::misfit::worldSampler::failReplicate(const label replicate)
{
    replicateChanges_ = 1e-4;
    failingReplicate_ = replicate;
}


Foam::scalar Foam::misfit::worldSampler::drawn
(
    const word& experiment,
    const label replicate
) const
{
    std::mt19937 generator(1000 + 10*replicate + (experiment == "A"));
    return 1 + replicateScatter_*std::normal_distribution<scalar>()(generator);
}


void Foam::misfit::worldSampler::scatterReplicates(const scalar deviation)
{
    replicateScatter_ = deviation;
    for (observation& o : data_)
    {
        const scalar recorded = drawn(o.experiment, 1 + world_.data.y.sum());
        o.calibration.y *= recorded;
        o.validation.y *= recorded;
    }
}


void Foam::misfit::worldSampler::testInB()
{
    data_[1].use = purpose::test;
    std::swap(data_[1].test, data_[1].validation);
}


void Foam::misfit::worldSampler::weakenGains(const scalar share)
{
    data_[0].validation = stacked();
    data_[0].calibration.y *= 1 - share;
    for (segment& s : data_[0].calibration.segments)
    {
        s.gainUncertainty = share;
    }
}


void Foam::misfit::worldSampler::recordConstant
(
    const label i,
    const scalar value
)
{
    stacked& calibration = data_[0].calibration;
    calibration.segments[i].of(calibration.y).setConstant(value);
}


void Foam::misfit::worldSampler::addGaugeBesideP2(const scalar uncertainty)
{
    gaugeBeside_ = true;
    stacked& calibration = data_[0].calibration;
    calibration.segments[1].uncertainty = uncertainty;
    segment beside(calibration.segments[1]);
    beside.name = "P2b";
    beside.first = calibration.y.size();
    calibration.y = joined(calibration.y, calibration.segments[1].of(calibration.y));
    calibration.segments.push_back(beside);
}


void Foam::misfit::worldSampler::refine(const scalar share)
{
    finerChanges_ = share;
}


void Foam::misfit::worldSampler::failFiner(const word& experiment)
{
    failsFiner_ = true;
    failsFinerIn_ = experiment;
}


void Foam::misfit::worldSampler::failAlwaysIn(const word& experiment)
{
    failingAlways_ = experiment;
}


void Foam::misfit::worldSampler::failIn(const word& experiment)
{
    failing_ = experiment;
}


void Foam::misfit::worldSampler::holdNothingOut()
{
    data_.resize(1);
    data_[0].validation = stacked();
}


void Foam::misfit::worldSampler::holdOutLessOf
(
    const vec& x,
    const scalar share
)
{
    data_.resize(1);
    vec without = x;
    without.tail(x.size() - world::nParameters).setZero();
    const vec effect = world_(x) - world_(without);
    data_[0].validation.y -= (1 - share)*world_.data.segments[2].of(effect);
}


void Foam::misfit::worldSampler::holdOutFew
(
    const label samples,
    const scalar added
)
{
    data_.resize(1);
    stacked& g = data_[0].validation;
    segment& few = g.segments[0];
    few.size = samples;
    few.x = vec(few.x.head(samples));
    few.readings = vec(few.readings.head(samples));
    g.y = vec(g.y.head(samples).array() + added);
}


void Foam::misfit::worldSampler::addContradiction()
{
    observation o(data_.last());
    o.experiment = "D";
    vec x = vec::Zero(world_.bounds.mean.size());
    x[0] = -0.3;
    o.validation.y = world_(x);
    data_.append(o);
}


Foam::scalar Foam::misfit::worldSampler::nearest(const runState& state) const
{
    const vec x = variables(state);
    vec width = vec::Ones(x.size());
    width.head(world::nParameters).setConstant(0.1);
    scalar least = GREAT;
    for (const runState& r : ran_)
    {
        const vec y = variables(r);
        const bool sameOn = ((x.array() > 0) == (y.array() > 0))
            .tail(x.size() - world::nParameters).all();
        if (r.experiment == state.experiment && sameOn)
        {
            least = min
            (
                least,
                (x - y).cwiseQuotient(width).cwiseAbs().maxCoeff()
            );
        }
    }
    return least;
}


Foam::label Foam::misfit::worldSampler::runs() const
{
    return requests_.size();
}


Foam::List<Foam::misfit::samples>
Foam::misfit::worldSampler::operator()(const List<runState>& states)
{
    List<samples> all(states.size());
    forAll(states, i)
    {
        requests_.insert(describe(states[i]));
        all[i] = run(states[i]);
        ran_.append(states[i]);
    }
    return all;
}


const Foam::List<Foam::misfit::observation>&
Foam::misfit::worldSampler::data() const
{
    return data_;
}
