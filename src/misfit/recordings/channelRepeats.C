// SPDX-License-Identifier: GPL-3.0-or-later
// What was recorded of one channel, as a mean where the experiment was done several
// times.

#include "channel.H"
#include "OStringStream.H"
#include "stringList.H"

#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Fewest readings of a repeat, over those of the first file [-]: a gap of a few makes
//  its mean no less sure, another rate does
constexpr scalar shareOfReadings = 0.9;


//- To the millisecond and millimetre, also of a logger that counts from 1970
string written(const scalar x)
{
    OStringStream os;
    os.precision(13);
    os << x;
    return os.str();
}


//- Fatal where too little of a file is in the interval that counts
void checkInterval
(
    const dictionary& dict,
    const word& channel,
    const Tuple2<scalar, scalar>& interval,
    const series& whole
)
{
    const label n = whole.within(interval.first(), interval.second()).x.size();
    if (n < 3)
    {
        FatalIOErrorInFunction(dict)
            << "The channel " << channel << " has " << n << " readings in the interval "
            << interval << "; it needs three. The file covers "
            << written(whole.x.first()).c_str() << " to "
            << written(whole.x.last()).c_str()
            << ". If it counts from elsewhere: xOffset" << exit(FatalIOError);
    }
}


//- Fatal where the experiment done again is a copy of one before, does not cover what
//  counts, or has fewer readings there: its mean with others would be less sure than it
//  looks
void checkRepeat
(
    const dictionary& dict,
    const word& channel,
    const List<recordedFile>& before,
    const recordedFile& again,
    const scalar from,
    const scalar to
)
{
    const series& x = again.readings;
    const label n = before[0].readings.within(from, to).x.size();
    std::ostringstream fault;
    fault.precision(13);
    for (const recordedFile& f : before)
    {
        if (x.isCopyOf(f.readings))
        {
            fault << "has the same numbers as " << f.source
                << ": a repeat is the experiment done again, not a copy";
        }
    }
    if (x.x.first() > from || x.x.last() < to)
    {
        fault << "covers " << x.x.first() << " to " << x.x.last() << ", but " << from
            << " to " << to << " counts: give an interval that all repeats cover";
    }
    else if (x.within(from, to).x.size() < shareOfReadings*n)
    {
        fault << "has " << x.within(from, to).x.size() << " readings where "
            << before[0].source << " has " << n << ": give the coarsest one as file";
    }
    if (fault.str().size())
    {
        FatalIOErrorInFunction(dict)
            << "The repeat " << again.source << " of the channel " << channel << ' '
            << fault.str().c_str() << exit(FatalIOError);
    }
}

} // End anonymous namespace


void Foam::misfit::channel::readFiles(const dictionary& dict, const fileName& folder)
{
    List<recordedFile> whole(1, readFile(dict, folder, dict.get<string>("file")));
    const series first(whole[0].readings);
    checkInterval(dict, name, interval, first);
    const scalar from = max(interval.first(), first.x.first());
    const scalar to = min(interval.second(), first.x.last());
    const stringList repeats(dict.getOrDefault("repeats", stringList()));
    for (const string& file : repeats)
    {
        const recordedFile again(readFile(dict, folder, file));
        checkRepeat(dict, name, whole, again, from, to);
        whole.append(again);
    }

    samples.repeats = whole.size();
    for (const recordedFile& f : whole)
    {
        files.append({f.source, f.readings.within(from, to)});
    }
    recorded = files[0].readings;
    forAll(recorded.x, i)
    {
        recorded.y[i] = 0;
        for (const recordedFile& f : whole)
        {
            recorded.y[i] += f.readings(recorded.x[i])/whole.size();
        }
    }
}
