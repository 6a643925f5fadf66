// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what a diagnosis found.

#include "report.H"
#include "recordedSource.H"
#include "textFile.H"
#include "words.H"

#include "clock.H"
#include "HashSet.H"

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- An experiment, its channels by their use, and the files they came from
stringList experimentRow(const recordings& all, const word& name)
{
    stringList row(5);
    row[0] = name;
    const auto add = [](string& list, const string& one)
    {
        list += (list.empty() ? "" : ", ") + one;
    };
    wordHashSet files;
    for (const channel& c : all.channels())
    {
        if (c.experiment == name && c.isRecorded())
        {
            const string times
            (
                c.files.size() > 1
              ? " (mean of " + Foam::name(c.files.size()) + ")" : string()
            );
            add(row[1 + label(c.use)], c.name + times);
            for (const recordedFile& f : c.files)
            {
                const fileName file(fileOfSource(f.source));
                if (file.size() && files.insert(file.name()))
                {
                    add(row[4], file.name());
                }
            }
        }
    }
    return row;
}

} // End anonymous namespace


Foam::misfit::origin Foam::misfit::originOf
(
    const string& title,
    const recordings& recorded,
    const List<candidate>& candidates
)
{
    origin from{title, clock::date(), {}, candidates};
    for (const word& name : recorded.experiments())
    {
        from.experiments.append(experimentRow(recorded, name));
    }
    return from;
}


Foam::string Foam::misfit::summaryOf(const finding& f, const fileName& folder)
{
    string text
    (
        "Verdict: " + verdictNames[f.verdict.kind] + '\n' + describe(f) + '\n'
      + "Confidence " + percentWords(f.verdict.confidence) + ' ' + sureThat(f) + '\n'
    );
    for (const place& p : f.verdict.located)
    {
        text += "    " + describe(p, f.detection.data) + '\n';
    }
    text += "States computed: " + Foam::name(f.nRuns) + '\n';
    if (f.verdict.state)
    {
        text += "\nThe case with it: " + folder/correctedCase + '\n';
    }
    return
        text + "\nTo read: " + folder/"report.html" + "\nThe record: "
      + folder/"verdict.json";
}


std::string Foam::misfit::verdictJson(const finding& f, const string& title)
{
    return recordOf(f, title).dump(2) + '\n';
}


void Foam::misfit::writeReport
(
    const finding& f,
    const fileName& folder,
    const origin& from
)
{
    const std::vector<figure> figures(drawFigures(f, folder/"plots"));
    writeWhole(folder/"report.html", reportHtml(f, from, figures));
    writeWhole(folder/"verdict.json", verdictJson(f, from.title));
}
