// SPDX-License-Identifier: GPL-3.0-or-later
// Predictions by runs of the solver.

#include "solverPredictor.H"
#include "failureOf.H"
#include "keywords.H"

#include "IFstream.H"
#include "OSspecific.H"
#include "SHA1.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::Tuple2<Foam::misfit::caseChange, Foam::scalar>>
Foam::misfit::solverPredictor::changes(const runState& state) const
{
    List<Tuple2<caseChange, scalar>> all;
    const auto add = [&all](const List<caseChange>& some, const scalar number)
    {
        for (const caseChange& c : some)
        {
            all.append(Tuple2<caseChange, scalar>(c, number));
        }
    };

    add(experiments_[state.experiment], 0);
    if (!state.isBase())
    {
        add(resolutions_[state.resolution], 0);
    }
    if (state.replicate)
    {
        add(replicateChanges_, state.replicate);
    }
    for (const parameter& p : parameters_)
    {
        if (state.parameters.found(p.name))
        {
            add(p.changes, state.parameters[p.name]);
        }
    }
    for (const candidate& c : candidates_)
    {
        const scalar strength = state.strengths.lookup(c.name, 0);
        if (strength != 0)
        {
            add(c.changes, strength);
        }
    }
    add(correction_.changes(state.strengths, state.noting, template_), 0);
    return all;
}


Foam::misfit::runRequest
Foam::misfit::solverPredictor::request(const runState& state) const
{
    const auto list(changes(state));
    const word experiment(state.experiment);
    dictionary measured;
    for (const observer& o : observers_)
    {
        if (o.of.experiment == experiment && o.measured.size())
        {
            measured.add(o.of.name, o.measured);
        }
    }

    OStringStream os;
    for (const auto& c : list)
    {
        os << c.first().describe(c.second()).c_str() << nl;
    }
    measured.write(os, false);

    return
    {
        os.str(),
        [this, list, measured, experiment](const fileName& caseFolder)
        {
            for (const auto& c : list)
            {
                c.first().apply(caseFolder, c.second());
            }
            IFstream is(caseFolder/"system"/"controlDict");
            const dictionary control(is);
            checkTables(control, experiment);
            checkEnd(control, experiment);
            for (const entry& e : measured)
            {
                OStringStream text;
                text.precision(12);
                e.dict().write(text);
                caseChange("system/controlDict", "functions/" + e.keyword(), text.str())
                    .apply(caseFolder, 0);
            }
        }
    };
}


bool Foam::misfit::solverPredictor::isBase(const runState& state) const
{
    bool atMean = true;
    for (const parameter& p : parameters_)
    {
        atMean = atMean && state.parameters.lookup(p.name, p.mean) == p.mean;
    }
    forAllConstIters(state.strengths, strength)
    {
        atMean = atMean && *strength == 0;
    }
    return atMean && !state.replicate && state.isBase();
}


Foam::misfit::prediction Foam::misfit::solverPredictor::read
(
    const runState& state,
    const runRequest& run
) const
{
    prediction p;
    p.failure = store_.failure(run);
    p.channels.setSize(observers_.size());
    forAll(p.channels, i)
    {
        const observer& o = observers_[i];
        if (!p.ok() || o.of.experiment != state.experiment)
        {
            continue;
        }
        const auto readIt = [&]()
        {
            p.channels[i] = o.read(store_.caseOf(run));
            p.failure = fault(o.of, p.channels[i]);
        };
        if (isBase(state))
        {
            readIt();
        }
        else if (const string failure(failureOf(readIt)); failure.size())
        {
            p.failure = failure;
        }
    }
    if (p.ok() && state.noting)
    {
        p.water = correction_.waterIn(store_.caseOf(run));
    }
    return p;
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::solverPredictor::solverPredictor
(
    const recordings& recorded,
    const fileName& templateCase,
    const dictionary& dict
)
:
    recordings_(recorded),
    parameters_(readParameters(keywords::sub(dict, "parameters"))),
    candidates_(readCandidates(keywords::sub(dict, "candidates"))),
    correction_(dict),
    template_(templateCase),
    replicateChanges_(readChanges(dict, "replicateChanges")),
    store_(templateCase, dict)
{
    const dictionary experiments(keywords::sub(dict, "experiments"));
    for (const word& name : recorded.experiments())
    {
        experiments_.insert
        (
            name,
            readChanges(keywords::sub(experiments, name), "changes")
        );
    }

    const dictionary finer
    (
        keywords::sub(dict, "resolution", wordList({"mesh", "schemes", "step"}))
    );
    for (const word& name : finer.toc())
    {
        resolutions_.insert(name, readChanges(finer, name));
    }

    for (const channel& c : recorded.channels())
    {
        observers_.emplace_back(c);
    }
    checkPlacesIn(templateCase, recorded.experiments(purpose::calibration).first());
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::misfit::prediction>
Foam::misfit::solverPredictor::predict(const List<runState>& states)
{
    List<runRequest> runs(states.size());
    forAll(states, i)
    {
        runs[i] = request(states[i]);
        if (!store_.isFinished(runs[i]))
        {
            rehearse();
        }
    }
    store_.finish(runs);

    List<prediction> result(states.size());
    forAll(states, i)
    {
        checkPlacesIn(store_.caseOf(runs[i]), states[i].experiment);
        checkWater(states[i], runs[i]);
        result[i] = read(states[i], runs[i]);
        if (!result[i].ok())
        {
            Info<< "    Failed: " << describe(states[i]).c_str() << ": "
                << result[i].failure.c_str() << nl << "    kept in "
                << store_.caseOf(runs[i]).path()
                << ": remove this folder to have it done again" << endl;
        }
    }
    return result;
}


Foam::string
Foam::misfit::solverPredictor::digest(const List<runState>& states) const
{
    string all;
    for (const runState& s : states)
    {
        all += request(s).description;
    }
    return SHA1(all).digest().str();
}


void Foam::misfit::solverPredictor::makeCase
(
    const runState& state,
    const fileName& target
)
{
    store_.makeCase(target, request(state));
}


void Foam::misfit::solverPredictor::print
(
    const string& what,
    const List<runState>& states
)
{
    Info<< what.c_str() << ": " << states.size() << " runs" << nl;
    label left = 0;
    for (const runState& s : states)
    {
        const runRequest run(request(s));
        const bool finished = store_.isFinished(run);
        if (!finished)
        {
            rehearse();
        }
        Info<< "    " << (finished ? "done  " : "to do ")
            << describe(s).c_str() << nl;
        left += !finished;
        donePrinted_ += finished;
        secondsPrinted_ += finished ? store_.seconds(run) : 0;
    }
    if (left && !donePrinted_)
    {
        Info<< "    none is done yet: how long they take is known from the"
            << " first one on" << nl;
    }
    if (left && donePrinted_)
    {
        const scalar minutes = secondsPrinted_/donePrinted_*left/store_.jobs()/60;
        Info<< "    about " << std::ceil(minutes) << " min for the " << left << " to do"
            << nl;
    }
    Info<< endl;
}
