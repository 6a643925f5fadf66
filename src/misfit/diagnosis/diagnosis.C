// SPDX-License-Identifier: GPL-3.0-or-later
// The stages of a diagnosis: calibration, detection, signatures.

#include "diagnosis.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::diagnosis::setBounds()
{
    const label nP = settings_.parameters.size();
    const label n = nP + settings_.candidates.size();
    bounds_.nParameters = nP;
    bounds_.mean = bounds_.deviation = vec::Zero(n);
    bounds_.lower = bounds_.upper = width_ = vec::Zero(n);
    for (label i = 0; i < nP; ++i)
    {
        const parameter& p = settings_.parameters[i];
        bounds_.mean[i] = p.mean;
        width_[i] = bounds_.deviation[i] = p.deviation;
        bounds_.lower[i] = p.lower;
        bounds_.upper[i] = p.upper;
    }
    forAll(settings_.candidates, i)
    {
        bounds_.upper[nP + i] = settings_.candidates[i].upper;
        width_[nP + i] = settings_.candidates[i].strong;
    }
}


Foam::wordList Foam::misfit::diagnosis::mechanismNames() const
{
    wordList names;
    for (const candidate& c : settings_.candidates)
    {
        names.append(c.name);
    }
    return names;
}


Foam::wordList
Foam::misfit::diagnosis::namesOf(const labelList& mechanisms) const
{
    wordList names;
    for (const label m : mechanisms)
    {
        names.append(settings_.candidates[m].name);
    }
    return names;
}


Foam::misfit::runState Foam::misfit::diagnosis::state
(
    const vec& variables,
    const label packing
) const
{
    runState s
    (
        stateOf(settings_, data().experiment, mechanismNames(), variables)
    );
    s.packing = packing;
    return s;
}


Foam::misfit::vec
Foam::misfit::diagnosis::variables(const runState& s) const
{
    vec x = bounds_.mean;
    forAll(settings_.parameters, i)
    {
        x[i] = s.parameters.lookup(settings_.parameters[i].name, x[i]);
    }
    forAll(settings_.candidates, i)
    {
        x[bounds_.nParameters + i] =
            s.strengths.lookup(settings_.candidates[i].name, 0);
    }
    return x;
}


Foam::List<Foam::misfit::samples>
Foam::misfit::diagnosis::ask(const List<runState>& states)
{
    found_.nRuns += states.size();
    return sampler_(states);
}


Foam::List<Foam::misfit::samples>
Foam::misfit::diagnosis::means(const List<runState>& states)
{
    found_.nRuns += states.size()*settings_.common;
    return sampler_.means(states, settings_.common);
}


Foam::List<Foam::misfit::samples>
Foam::misfit::diagnosis::means(const List<vec>& variables)
{
    List<runState> states;
    for (const vec& x : variables)
    {
        states.append(state(x, 0));
    }
    return means(states);
}


Foam::stringList
Foam::misfit::diagnosis::addRuns(const List<vec>& variables)
{
    const List<samples> given(means(variables));
    stringList failures(given.size());
    forAll(given, i)
    {
        failures[i] = given[i].failure;
        if (given[i].ok())
        {
            fit_->addRun(variables[i], given[i].fit);
            gate_->addRun(variables[i], given[i].gate);
        }
    }
    return failures;
}


void Foam::misfit::diagnosis::build()
{
    fit_->build(width_);
    gate_->build(width_);
}


void Foam::misfit::diagnosis::findNever
(
    const List<vec>& design,
    const stringList& failures
)
{
    forAll(settings_.candidates, m)
    {
        label asked = 0;
        label ran = 0;
        forAll(design, i)
        {
            const bool on = design[i][bounds_.nParameters + m] > 0;
            asked += on;
            ran += on && failures[i].empty();
        }
        if (asked && !ran)
        {
            never_.append(m);
        }
    }
}


void Foam::misfit::diagnosis::calibrationRuns()
{
    Info<< "S1 calibration" << endl;
    List<vec> design(settings_.bank ? bankDesign() : parameterDesign());
    if (sampler_.bank().size())
    {
        design.clear();
        for (const runState& s : sampler_.bank())
        {
            design.append(variables(s));
        }
    }
    const stringList failures(addRuns(design));
    forAll(design, i)
    {
        if (failures[i].size())
        {
            leaveOut(state(design[i]), failures[i]);
        }
    }
    findNever(design, failures);
    build();
}


void Foam::misfit::diagnosis::detect()
{
    const vec atMean = fit_->surface()(bounds_.mean);
    const whitener white(fit_->uncertainty().at(atMean));
    const scan raw(fit_->data(), white, settings_.draws, settings_.seed);
    found_.raw = raw(fit_->data().y - atMean, settings_.significance);

    const weighed base
    (
        fit_->weigh(settings_.formulaTolerance).base()
    );
    for (label i = 0; i < bounds_.nParameters; ++i)
    {
        const parameter& p = settings_.parameters[i];
        found_.parameters.append
        ({
            p.name, p.mean, p.deviation, base.best.x[i],
            base.best.deviation(i), base.best.pinned[i]
        });
    }

    Info<< "S2 detection" << endl;
    found_.detection = look(*fit_, base, shapes(base));
    locate(fit_->data().y - base.best.f, base.covariance);
    found_.data = fit_->data();
    found_.sigma = base.covariance.diagonal().cwiseSqrt();
    found_.sources = fit_->uncertainty().sources(base.best.f);
    screen(base);
    if (found_.detection.p < settings_.significance)
    {
        signatureRuns(base);
    }
}


Foam::misfit::scanned Foam::misfit::diagnosis::look
(
    const sampledModel& m,
    const weighed& w,
    const mat& shapes
) const
{
    const hypothesisModel model(m.surface(), bounds_, w.what);
    const mat slopes = model.slopes(w.best.x);
    const vec deviation = model.deviation();
    const vec fromMean = deviation.unaryExpr
    (
        [](const scalar d) { return d > 0 ? 1.0 : 0.0; }
    ).cwiseProduct(w.best.x - model.mean());

    const whitener white(withFitted(w.covariance, slopes, deviation));
    const scan look(m.data(), white, settings_.draws, settings_.seed, shapes);
    return look
    (
        m.data().y - w.best.f + slopes*fromMean,
        settings_.significance
    );
}


void Foam::misfit::diagnosis::signatureRuns(const weighed& base)
{
    if (settings_.bank || sampler_.bank().size())
    {
        return;
    }
    Info<< "S5 signatures" << endl;
    vec at = bounds_.mean;
    at.head(bounds_.nParameters) = base.best.x.head(bounds_.nParameters);
    List<vec> design(1, at);
    design.append(signatureDesign(at, mechanisms_));

    const stringList failures(addRuns(design));
    labelList left;
    forAll(mechanisms_, i)
    {
        const string& weak = failures[1 + 2*i];
        const string& strong = failures[2 + 2*i];
        if (weak.empty() || strong.empty())
        {
            left.append(mechanisms_[i]);
        }
        else
        {
            never_.append(mechanisms_[i]);
            found_.dropped.append
            (
                Tuple2<word, string>
                (
                    settings_.candidates[mechanisms_[i]].name,
                    "the solver failed with it: " + weak
                )
            );
        }
    }
    mechanisms_ = left;
    build();
}


void Foam::misfit::diagnosis::explain()
{
    Info<< "S3 sensors, S5 mechanisms" << endl;
    if (found_.detection.p >= settings_.significance)
    {
        mechanisms_.clear();
    }
    found_.explanations = fit_->weigh(settings_.formulaTolerance).all
    (
        mechanisms_,
        possibleFaults(fit_->data(), settings_.faults),
        settings_.pairs
    );
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::diagnosis::diagnosis(sampler& s, const settings& set)
:
    sampler_(s),
    settings_(set)
{
    setBounds();
    found_.library = mechanismNames();
    for (const segment& s : data().fit.segments)
    {
        if (!s.overTime && !s.isNumber() && set.trigger > 0)
        {
            WarningInFunction
                << "trigger is not counted in " << s.name.c_str() << ", which is no"
                << " series over time: put what the clock's error moves it by into"
                << " its uncertainty" << endl;
        }
    }
    fit_.reset(new sampledModel(data().fit, bounds_, set.trigger));
    gate_.reset(new sampledModel(data().gate, bounds_, set.trigger));
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

const Foam::misfit::finding& Foam::misfit::diagnosis::operator()()
{
    uncertainty();
    calibrationRuns();
    detect();
    explain();
    refit();
    prefer();
    compare(baseline());
    Info<< "S7 gates" << endl;
    askGates();
    Info<< "S9 verdict" << endl;
    decide();
    correct();
    return found_;
}


Foam::List<Foam::Tuple2<Foam::string, Foam::List<Foam::misfit::runState>>>
Foam::misfit::diagnosis::plan() const
{
    List<Tuple2<string, List<runState>>> stages;
    const auto add = [&](const string& what, const List<vec>& design)
    {
        List<runState> states;
        for (const vec& x : design)
        {
            for (label packing = 0; packing < settings_.common; ++packing)
            {
                states.append(state(x, packing));
            }
        }
        stages.append(Tuple2<string, List<runState>>(what, states));
    };

    const List<runState> all(bases());
    List<runState> first(uncertaintyRuns(data().experiment));
    for (const runState& base : SubList<runState>(all, all.size() - 1, 1))
    {
        first.append(base);
    }
    stages.append(Tuple2<string, List<runState>>("S0 uncertainty", first));

    if (settings_.bank)
    {
        add("S1 and S5, a bank of random runs", bankDesign());
        stages.append(correctionPlan());
        return stages;
    }
    add("S1 calibration", parameterDesign());

    add
    (
        "S5 signatures (around the calibrated state, not the one shown)",
        signatureDesign(bounds_.mean, identity(settings_.candidates.size()))
    );
    stages.append(correctionPlan());
    return stages;
}
