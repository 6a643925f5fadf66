// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of the design of an experiment.

#include "designSettings.H"
#include "keywords.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Names of the channels of the fitted experiment that are for calibration; recorded:
//  only those with a file
wordList calibrating(const recordings& all, const bool recorded)
{
    wordList names;
    for (const channel& c : all.channels())
    {
        const bool fits =
            c.use == purpose::calibration && c.isRecorded()
         && all.experiments(purpose::calibration).found(c.experiment);
        if (fits && !(recorded && c.isPlanned))
        {
            names.append(c.name);
        }
    }
    return names;
}


void check(const dictionary& dict, const designSettings& d, const recordings& recorded)
{
    const wordList valid(calibrating(recorded, false));
    for (const word& name : d.channels)
    {
        if (!valid.found(name))
        {
            FatalIOErrorInFunction(dict)
                << "design names the channel " << name
                << ", which is no channel over time of the fitted experiment, or is held"
                << " out. Channels:"
                << keywords::listed(valid).c_str() << exit(FatalIOError);
        }
    }
    const auto isAbove = [](const scalar x) { return x > 0; };
    const bool strengths =
        d.strengths.size()
     && std::all_of(d.strengths.begin(), d.strengths.end(), isAbove);
    const bool repeats =
        d.repeats.size() && *std::min_element(d.repeats.begin(), d.repeats.end()) > 0
     && std::is_sorted(d.repeats.begin(), d.repeats.end());
    if (!strengths || !repeats || d.draws < 1 || d.probability <= 0 || d.probability >= 1)
    {
        FatalIOErrorInFunction(dict)
            << "In design, strengths must be above 0, repeats 1 or more and rising,"
            << " draws 1 or more, and probability between 0 and 1" << exit(FatalIOError);
    }
    if (d.channels.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No channel of the fitted experiment can be recorded: all are held out, or"
            << " are profiles without a file. Give channels, with interval or rate"
            << exit(FatalIOError);
    }
}

} // End anonymous namespace


Foam::misfit::designSettings
Foam::misfit::readDesign(const dictionary& dict, const recordings& recorded)
{
    const dictionary design(keywords::sub(dict, "design"));
    keywords::check
    (
        design, {"channels", "strengths", "repeats", "draws", "probability"}
    );
    designSettings d;
    d.channels = calibrating(recorded, true);
    if (d.channels.empty())
    {
        d.channels = calibrating(recorded, false);
    }
    design.readIfPresent("channels", d.channels);
    design.readIfPresent("strengths", d.strengths);
    design.readIfPresent("repeats", d.repeats);
    design.readIfPresent("draws", d.draws);
    design.readIfPresent("probability", d.probability);
    check(design, d, recorded);
    return d;
}
