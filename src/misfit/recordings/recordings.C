// SPDX-License-Identifier: GPL-3.0-or-later
// All that was recorded, of all experiments, and what each part is used for.

#include "recordings.H"
#include "keywords.H"

#include <algorithm>

namespace
{

using namespace Foam;

//- The uses of recordings by the names that they had
HashTable<word> formerUses()
{
    return HashTable<word>
    ({
        {"fit", "calibration"}, {"gate", "validation"}, {"score", "test"}
    });
}


enum class sharing { nothing, part, all };


//- How many readings of two files are the same
sharing sharedReadings(const misfit::recordedFile& a, const misfit::recordedFile& b)
{
    const misfit::series& first = a.readings;
    const misfit::series& second = b.readings;

    // By their numbers: the same file may have another name, or be a copy
    if (first.isCopyOf(second))
    {
        return sharing::all;
    }
    const bool overlap =
        a.source == b.source
     && first.x.first() < second.x.last() && second.x.first() < first.x.last();
    return overlap ? sharing::part : sharing::nothing;
}


//- Two files with readings in common
struct sharedFiles
{
    sharing readings = sharing::nothing;

    string first;

    string second;
};


//- The first two files of two channels that share readings
sharedFiles findShared(const misfit::channel& a, const misfit::channel& b)
{
    for (const misfit::recordedFile& ofA : a.files)
    {
        for (const misfit::recordedFile& ofB : b.files)
        {
            const sharing readings = sharedReadings(ofA, ofB);
            if (readings != sharing::nothing)
            {
                return {readings, ofB.source, ofA.source};
            }
        }
    }
    return {};
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::recordings::readExperiments(const dictionary& dict)
{
    if (!dict.found("experiments"))
    {
        experiments_ = wordList(1, word("A"));
        purposes_ = List<purpose>(1, purpose::calibration);
        return;
    }

    for (const entry& e : dict.subDict("experiments"))
    {
        keywords::check(e.dict(), {"use", "changes"});
        if (word(e.keyword()).find('+') != string::npos)
        {
            FatalIOErrorInFunction(dict)
                << "The name of the experiment " << e.keyword()
                << " has a +, which stands between the names of several: give it another"
                << exit(FatalIOError);
        }
        experiments_.append(e.keyword());
        purposes_.append
        (
            purposeNames
            [
                keywords::choice
                (
                    e.dict(), "use", "use", purposeNames.sortedToc(),
                    "calibration", formerUses()
                )
            ]
        );
    }

    if (experiments(purpose::calibration).empty())
    {
        FatalIOErrorInFunction(dict)
            << "None of the experiments" << keywords::listed(experiments_).c_str()
            << " is there to calibrate with: give one of them  use calibration;"
            << exit(FatalIOError);
    }
}


Foam::HashTable<Foam::misfit::purpose>
Foam::misfit::recordings::readHeldOut(const dictionary& dict) const
{
    HashTable<purpose> held;
    const dictionary lists(keywords::sub(dict, "heldOut"));
    keywords::checkRenamed(lists, formerUses());
    keywords::check(lists, {"validation", "test"});

    for (const entry& e : lists)
    {
        for (const word& name : lists.get<wordList>(e.keyword()))
        {
            if (!dict.subDict("channels").found(name))
            {
                FatalIOErrorInFunction(lists)
                    << "heldOut names " << name << ", which is no channel."
                    << " Channels:"
                    << keywords::listed(dict.subDict("channels").toc()).c_str()
                    << exit(FatalIOError);
            }
            if (!held.insert(name, purposeNames[e.keyword()]))
            {
                FatalIOErrorInFunction(lists)
                    << "heldOut lists " << name << " twice. A channel either"
                    << " validates or tests: name it once" << exit(FatalIOError);
            }
        }
    }
    return held;
}


void Foam::misfit::recordings::checkOnce(const dictionary& dict) const
{
    forAll(channels_, i)
    {
        const channel& a = channels_[i];
        for (label j = 0; j < i; ++j)
        {
            const channel& b = channels_[j];
            const sharedFiles shared(findShared(a, b));
            if (shared.readings == sharing::nothing)
            {
                continue;
            }

            const string message
            (
                "The channels " + b.name + " and " + a.name
              + (shared.readings == sharing::all ? " are" : " have some of")
              + " the same numbers, " + shared.first + " and " + shared.second
            );
            if (a.use == purpose::calibration && b.use == purpose::calibration)
            {
                WarningInFunction
                    << message.c_str() << ", which count twice now. Remove one, or"
                    << " give them intervals that do not overlap" << endl;
                continue;
            }
            FatalIOErrorInFunction(dict)
                << message.c_str() << ". What is held out must not be seen"
                << " elsewhere: remove one, or give them intervals that do not overlap"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::recordings::recordings
(
    const dictionary& dict,
    const fileName& folder
)
{
    readExperiments(dict);
    const HashTable<purpose> held(readHeldOut(dict));
    samples_ = dict.getOrDefault<label>("samples", 40);
    if (samples_ < 5)
    {
        FatalIOErrorInFunction(dict)
            << "samples is " << samples_ << "; a channel needs at least five to"
            << " show when it departs from the simulation" << exit(FatalIOError);
    }

    for (const entry& e : dict.subDict("channels"))
    {
        const purpose use = held.lookup(e.keyword(), purpose::calibration);
        channels_.append
        (
            new channel(e.keyword(), e.dict(), use, folder, samples_)
        );

        channel& c = channels_.last();
        if (!experiments_.found(c.experiment))
        {
            FatalIOErrorInFunction(e.dict())
                << "The channel " << c.name << " belongs to the experiment "
                << c.experiment << ", which is not there. Experiments:"
                << keywords::listed(experiments_).c_str() << exit(FatalIOError);
        }
        // A test channel stays one, whatever its experiment is for
        c.use = std::max(use, this->use(c.experiment));
    }
    checkOnce(dict);
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::misfit::purpose
Foam::misfit::recordings::use(const word& experiment) const
{
    return purposes_[experiments_.find(experiment)];
}


Foam::wordList
Foam::misfit::recordings::experiments(const purpose use) const
{
    wordList names;
    forAll(experiments_, i)
    {
        if (purposes_[i] == use)
        {
            names.append(experiments_[i]);
        }
    }
    return names;
}


Foam::word Foam::misfit::recordings::calibrated() const
{
    word all;
    for (const word& name : experiments(purpose::calibration))
    {
        all += (all.empty() ? "" : "+") + name;
    }
    return all;
}


Foam::wordList
Foam::misfit::recordings::parts(const word& experiment) const
{
    return
        experiment == calibrated()
      ? experiments(purpose::calibration) : wordList(1, experiment);
}


Foam::labelList Foam::misfit::recordings::select
(
    const word& experiment,
    const purpose use
) const
{
    labelList chosen;
    for (const word& part : parts(experiment))
    {
        forAll(channels_, i)
        {
            const channel& c = channels_[i];
            if (c.isRecorded() && c.experiment == part && c.use == use)
            {
                chosen.append(i);
            }
        }
    }
    return chosen;
}


void Foam::misfit::recordings::checkHeldOut(const dictionary& dict) const
{
    for (const word& e : experiments_)
    {
        bool recorded = false;
        for (const channel& c : channels_)
        {
            recorded = recorded || (c.experiment == e && c.isRecorded());
            if
            (
                c.experiment == e && use(e) == purpose::calibration
             && c.use != purpose::calibration && !c.isRecorded()
            )
            {
                FatalIOErrorInFunction(dict)
                    << "heldOut names " << c.name << ", which has no recording."
                    << " Give it a file, or take it out of heldOut"
                    << exit(FatalIOError);
            }
        }
        const bool alone =
            use(e) == purpose::calibration
         && experiments(purpose::calibration).size() == 1;
        if (!recorded && !alone)
        {
            FatalIOErrorInFunction(dict)
                << "The experiment " << e << " has no recorded channel, so its"
                << " runs decide nothing. Give it one, or take it out"
                << exit(FatalIOError);
        }
    }
}


void Foam::misfit::recordings::plan()
{
    const wordList fitted(experiments(purpose::calibration));
    scalar first = GREAT;
    scalar last = -GREAT;
    for (const channel& c : channels_)
    {
        if (c.isRecorded() && c.overTime() && fitted.found(c.experiment))
        {
            first = min(first, c.recorded.x.first());
            last = max(last, c.recorded.x.last());
        }
    }
    for (channel& c : channels_)
    {
        if (!c.isRecorded() && c.overTime() && fitted.found(c.experiment))
        {
            const bool isLimited = c.interval.first() > -GREAT;
            c.plan
            (
                isLimited ? c.interval.first() : first,
                isLimited ? c.interval.second() : last,
                samples_
            );
        }
    }
}


void Foam::misfit::recordings::checkEnough
(
    const dictionary& dict,
    const label unknowns
) const
{
    checkHeldOut(dict);
    if (dict.found("correction") && experiments(purpose::calibration).size() > 1)
    {
        FatalIOErrorInFunction(dict)
            << "A free correction follows the water of one experiment, and"
            << keywords::listed(experiments(purpose::calibration)).c_str()
            << " are all for calibration. Take correction out, or give all but one of"
            << " them  use validation;" << exit(FatalIOError);
    }
    label samples = 0;
    for (const channel& c : channels_)
    {
        samples += c.use == purpose::calibration ? c.samples.size : 0;
    }
    if (!samples)
    {
        FatalIOErrorInFunction(dict)
            << "No recorded channel is left to calibrate with: all are held out,"
            << " or have no file" << exit(FatalIOError);
    }
    if (samples < unknowns)
    {
        FatalIOErrorInFunction(dict)
            << "The calibration channels have " << samples << " samples for "
            << unknowns << " unknowns (parameters and two strengths)."
            << " Record more, or fix some of the parameters"
            << exit(FatalIOError);
    }
}
