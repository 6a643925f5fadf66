// SPDX-License-Identifier: GPL-3.0-or-later
// Which mechanisms an experiment could tell apart, before it is done.

#include "experimentDesign.H"
#include "diagnosis.H"
#include "parallelWork.H"
#include "simulatedRecordings.H"
#include "words.H"

#include "clockTime.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- No words on the terminal while it exists
class silence
{
    const int before_ = messageStream::level;

public:

    silence()
    {
        messageStream::level = 0;
    }

    ~silence()
    {
        messageStream::level = before_;
    }
};


//- What is diagnosed: recordings of a cause, drawn so many times
struct cause
{
    //- -1: nothing is wrong
    label mechanism;

    //- Over the second of its `strengths`
    scalar strength;
};


//- Channels that could be recorded besides those that are
wordList possibleChannels(const allChannels& all, const wordList& recorded)
{
    wordList names;
    forAll(all.uses(), i)
    {
        const word name(all.data().segments[i].name, false);
        if (!recorded.found(name) && all.uses()[i] != purpose::validation)
        {
            names.append(name);
        }
    }
    return names;
}


//- Candidates with which at least one run of the sensitivities ended
labelList runningCandidates(sampler& ask, const settings& set)
{
    const study s(ask, set);
    labelList some;
    forAll(set.candidates, m)
    {
        List<runState> states;
        for (const vec& x : s.sensitivityDesign(s.bounds.centre, {int(m)}))
        {
            states.append(s.state(x));
        }
        for (const runState& one : ask.trainingEnsemble())
        {
            if (one.strengths.lookup(set.candidates[m].name, 0) > 0)
            {
                states.append(one);
            }
        }
        const List<samples> given(ask(states));
        if (std::any_of(given.begin(), given.end(), [](const samples& g) { return g.ok(); }))
        {
            some.append(m);
        }
    }
    return some;
}


//- Standard error of a mean
scalar standardErrorOf(const std::vector<scalar>& values)
{
    const scalar n = values.size();
    if (n < 2)
    {
        return GREAT;
    }
    const vec v = Eigen::Map<const vec>(values.data(), values.size());
    return std::sqrt((v.array() - v.mean()).square().sum()/(n - 1)/n);
}


//- Marks the options that are behind the first by no more than twice the standard error of
//  the difference: the draws are the same with each channel
void markTied(List<designOption>& options)
{
    for (designOption& o : options)
    {
        std::vector<scalar> behind(o.gains);
        for (size_t k = 0; k < behind.size(); ++k)
        {
            behind[k] = options.first().gains[k] - o.gains[k];
        }
        const scalar mean = options.first().gain() - o.gain();
        o.isTied = mean <= 2*standardErrorOf(behind);
    }
    const label tied = std::count_if
    (
        options.begin(), options.end(), [](const designOption& o) { return o.isTied; }
    );
    if (tied == 1)
    {
        options.first().isTied = false;
    }
}


class designer
{
    sampler& ask_;

    //- Without a free correction, whose runs no surface has
    const settings set_;

    const designSettings& design_;

    const label jobs_;

    //- Numbers of the candidates that ran
    const labelList running_;

    const label nRows_;

    label nDone_ = 0;

    const clockTime timer_;


    static settings withoutCorrection(settings set)
    {
        set.correction.clear();
        return set;
    }

    //- One answer: "detected", the verdict, its confidence, and the names in it
    std::string answer
    (
        const simulatedRecordings& recordings,
        const cause& c,
        const wordList& channels,
        const label draw
    ) const;

    //- Adds an answer to the row
    void count(designRow& row, const std::string& answer) const;

    void printProgress(const designRow& row);


public:

    designer
    (
        sampler& ask,
        const settings& set,
        const designSettings& design,
        const label jobs
    );

    const settings& set() const
    {
        return set_;
    }

    const labelList& running() const
    {
        return running_;
    }

    //- Nothing wrong, then each mechanism and strength
    std::vector<cause> causes() const;

    designRow row
    (
        const simulatedRecordings& recordings,
        const cause& c,
        const wordList& channels,
        const label repeats
    );
};


std::string designer::answer
(
    const simulatedRecordings& recordings,
    const cause& c,
    const wordList& channels,
    const label draw
) const
{
    const silence quiet;
    const scalar strength =
        c.mechanism < 0 ? 0 : c.strength*set_.candidates[c.mechanism].strong;
    channelSelection some
    (
        ask_, recordings.all(), recordings(c.mechanism, strength, draw), channels, true
    );
    const finding f(diagnose(some, set_));
    std::ostringstream os;
    os << f.tests.gates.passed(gateKind::detection) << ' ' << verdictNames[f.verdict.kind]
        << ' ' << f.verdict.confidence;
    if (f.verdict.kind == verdictKind::set)
    {
        // Each member by its mechanisms or its channel
        for (const hypothesisFit& w : f.verdict.alternatives)
        {
            os << ' '
                << (w.what.fault ? w.what.fault->channel : describe(w.what.known(), f.library));
            os << ';';
        }
    }
    else
    {
        os << ' ' << joined(f.verdict.names, " and ") << ';';
    }
    return os.str();
}


void designer::count(designRow& row, const std::string& answer) const
{
    std::istringstream is(answer);
    bool detected = false;
    std::string verdict;
    scalar confidence = 0;
    is >> detected >> verdict >> confidence;
    bool has = false;
    for (std::string member; std::getline(is, member, ';');)
    {
        const word name(member.substr(std::min<size_t>(1, member.size())), false);
        has = has || (name.size() && name == row.mechanism);
        if (name.size() && name != row.mechanism)
        {
            ++row.others[name];
        }
    }
    const bool right = has && row.mechanism.size();
    const bool blames = verdict != "none" && verdict != "unknown";
    ++row.draws;
    row.detected += detected;
    row.named += verdict == "named" && right;
    row.inSet += verdict == "set" && right;
    row.wrong += blames && !right;
    row.none += verdict == "none";
    row.unknown += verdict == "unknown";
    row.namedIn.push_back(verdict == "named" && right);
    const bool isTrue = row.mechanism.empty() ? verdict == "none" : blames && right;
    row.confidences += confidence;
    row.squares += sqr(confidence - isTrue);
}


void designer::printProgress(const designRow& row)
{
    ++nDone_;
    const scalar left = timer_.elapsedTime()/nDone_*max(nRows_ - nDone_, label(0));
    Info<< "    " << nDone_ << " of " << nRows_ << ": "
        << (row.mechanism.empty() ? word("nothing") : row.mechanism) << ' ' << row.strength
        << ", repeats " << row.repeats << ": named " << row.named << " of " << row.draws
        << "; about " << std::ceil(left/60) << " min left" << endl;
}


designer::designer
(
    sampler& ask,
    const settings& set,
    const designSettings& design,
    const label jobs
)
:
    ask_(ask),
    set_(withoutCorrection(set)),
    design_(design),
    jobs_(jobs),
    running_(runningCandidates(ask, set)),
    nRows_
    (
        design.repeats.size()*(1 + running_.size()*design.strengths.size())
      + running_.size()
       *possibleChannels(allChannels(ask.data().first(), 1), design.channels).size()
    )
{}


std::vector<cause> designer::causes() const
{
    std::vector<cause> all({{-1, 0}});
    for (const label m : running_)
    {
        for (const scalar strength : design_.strengths)
        {
            all.push_back({m, strength});
        }
    }
    return all;
}


designRow designer::row
(
    const simulatedRecordings& recordings,
    const cause& c,
    const wordList& channels,
    const label repeats
)
{
    designRow row;
    row.mechanism = c.mechanism < 0 ? word() : set_.candidates[c.mechanism].name;
    row.strength = c.strength;
    row.repeats = repeats;
    const auto work = [&](const label draw)
    {
        return answer(recordings, c, channels, draw);
    };
    for (const std::string& one : inProcesses(design_.draws, jobs_, work))
    {
        count(row, one);
    }
    printProgress(row);
    return row;
}


//- Of the rows of a mechanism with so many repeats the one nearest to one half
const designRow& leastCertain
(
    const List<designRow>& rows,
    const word& mechanism,
    const label repeats
)
{
    const designRow* best = nullptr;
    const auto distance = [](const designRow& r) { return mag(r.share(r.named) - 0.5); };

    // Of those that are never named the strongest: there a channel may help
    const auto isNearer = [&](const designRow& r)
    {
        return
            distance(r) < distance(*best)
         || (distance(r) == distance(*best) && r.share(r.named) < 0.5);
    };
    for (const designRow& r : rows)
    {
        const bool its = r.mechanism == mechanism && r.repeats == repeats;
        if (its && (!best || isNearer(r)))
        {
            best = &r;
        }
    }
    return *best;
}


//- What a channel adds where names are least certain
designOption withChannel
(
    designer& by,
    const simulatedRecordings& recordings,
    const experimentDesign& known,
    const word& channel,
    const label repeats
)
{
    designOption option;
    option.channel = channel;
    wordList channels(known.channels);
    channels.append(channel);
    const scalar n = by.running().size();
    for (const label m : by.running())
    {
        const designRow& without =
            leastCertain(known.rows, by.set().candidates[m].name, repeats);
        const designRow with
        (
            by.row(recordings, {m, without.strength}, channels, repeats)
        );
        option.gains.resize(with.namedIn.size());
        for (size_t k = 0; k < with.namedIn.size(); ++k)
        {
            option.gains[k] += with.namedIn[k] - without.namedIn[k];
        }
        option.before += without.share(without.named);
        option.after += with.share(with.named);
        option.rows.append(with);
    }

    // At the end: all of them are 1, and none of them 0, to the last bit
    for (scalar& gain : option.gains)
    {
        gain /= n;
    }
    option.before /= n;
    option.after /= n;
    return option;
}

} // End anonymous namespace


Foam::scalar Foam::misfit::designOption::standardError() const
{
    return standardErrorOf(gains);
}


const Foam::misfit::designRow& Foam::misfit::experimentDesign::row
(
    const word& mechanism,
    const scalar strength,
    const label repeats
) const
{
    for (const designRow& r : rows)
    {
        if (r.mechanism == mechanism && r.strength == strength && r.repeats == repeats)
        {
            return r;
        }
    }
    FatalErrorInFunction
        << "The design has no row of " << mechanism << ' ' << strength << " with "
        << repeats << " repeats" << exit(FatalError);
    return rows.first();
}


Foam::label Foam::misfit::experimentDesign::repeatsNeeded
(
    const word& mechanism,
    const scalar strength
) const
{
    label least = 0;
    for (const designRow& r : rows)
    {
        const bool its = r.mechanism == mechanism && r.strength == strength;
        if (its && r.share(r.named) >= probability && (!least || r.repeats < least))
        {
            least = r.repeats;
        }
    }
    return least;
}


void Foam::misfit::checkStrengths
(
    const dictionary& dict,
    const designSettings& design,
    const settings& set
)
{
    for (const candidate& c : set.candidates)
    {
        for (const scalar strength : design.strengths)
        {
            if (strength*c.strong > c.upper*(1 + SMALL))
            {
                FatalIOErrorInFunction(dict)
                    << "In design, the strength " << strength << " is " << strength*c.strong
                    << " of the candidate " << c.name << ", and no fit goes beyond its upper, "
                    << c.upper << ". Take " << strength << " out of strengths; where the"
                    << " case takes such a strength, set upper " << strength*c.strong
                    << "; in the candidate" << exit(FatalIOError);
            }
        }
    }
}


Foam::misfit::experimentDesign Foam::misfit::designExperiment
(
    sampler& ask,
    const settings& set,
    const designSettings& design,
    const label jobs
)
{
    designer by(ask, set, design, jobs);
    experimentDesign all;
    all.channels = design.channels;
    all.probability = design.probability;
    forAll(set.candidates, m)
    {
        if (!by.running().found(m))
        {
            all.failing.append(set.candidates[m].name);
        }
    }
    for (const label repeats : design.repeats)
    {
        const simulatedRecordings recordings(ask, by.set(), repeats);
        for (const cause& c : by.causes())
        {
            all.rows.append(by.row(recordings, c, design.channels, repeats));
        }
    }

    const label repeats = design.repeats.first();
    const simulatedRecordings recordings(ask, by.set(), repeats);
    for (const word& channel : possibleChannels(recordings.all(), design.channels))
    {
        all.options.append(withChannel(by, recordings, all, channel, repeats));
    }
    std::stable_sort
    (
        all.options.begin(), all.options.end(),
        [](const designOption& a, const designOption& b)
        {
            return a.gain() > b.gain();
        }
    );
    markTied(all.options);
    return all;
}
