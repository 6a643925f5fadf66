// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a report, drawn by gnuplot.

#include "report.H"
#include "words.H"

#include "OSspecific.H"

#include <fstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Recorded, its standard deviation, before and after, a block a channel
void writeSeries
(
    const fileName& file,
    const stacked& data,
    const vec& sigma,
    const vec& before,
    const vec& after
)
{
    std::ofstream os(file);
    os << "# x recorded deviation before after\n";
    for (const segment& s : data.segments)
    {
        for (label i = s.first; i < s.first + s.size; ++i)
        {
            os  << s.x[i - s.first] << ' ' << data.y[i] << ' ' << sigma[i]
                << ' ' << before[i] << ' ' << after[i] << '\n';
        }
        os << "\n\n";
    }
}


//- What etc/misfit/series.gp needs to know of the channels
std::string seriesVariables
(
    const stacked& data,
    const std::string& file,
    const bool hasFinding
)
{
    std::ostringstream os;
    os  << "file = '" << file << "'; found = " << hasFinding << "; n = "
        << data.segments.size()
        << "\narray Title[n]; array Unit[n]; array Axis[n]; array Length[n]\n";
    label i = 0;
    for (const segment& s : data.segments)
    {
        ++i;
        os  << "Title[" << i << "] = '" << s.name << " (" << s.quantity << ")'; Unit["
            << i << "] = '" << unitOf(s.quantity) << "'; Axis[" << i << "] = '"
            << (s.isNumber() ? "" : s.overTime ? "time [s]" : "distance [m]")
            << "'; Length[" << i << "] = " << max(s.duration(), VSMALL) << '\n';
    }
    return os.str();
}


//- Boxes of the misfit over its deviation, which may be another one with what was found:
//  x from to, row, before, after
void writeMap
(
    std::ostream& os,
    const stacked& data,
    const vec& sigmaBefore,
    const vec& sigmaAfter,
    const vec& before,
    const vec& after,
    const label firstRow
)
{
    // A number alone is as wide as all the others together
    scalar least = GREAT;
    scalar most = -GREAT;
    for (const segment& s : data.segments)
    {
        least = min(least, s.isNumber() ? least : s.x[0]);
        most = max(most, s.isNumber() ? most : s.x[s.size - 1]);
    }
    if (most < least)
    {
        least = 0;
        most = 1;
    }

    for (label k = 0; k < count(data.segments); ++k)
    {
        const segment& s = data.segments[k];
        for (label i = 0; i < s.size; ++i)
        {
            const label j = s.first + i;
            const scalar left =
                s.isNumber() ? least
              : i ? 0.5*(s.x[i] + s.x[i-1]) : s.x[i] - 0.5*s.span;
            const scalar right =
                s.isNumber() ? most
              : i + 1 < s.size ? 0.5*(s.x[i] + s.x[i+1])
              : s.x[i] + 0.5*s.span;
            os  << left << ' ' << right << ' ' << firstRow + k << ' '
                << (data.y[j] - before[j])/sigmaBefore[j] << ' '
                << (data.y[j] - after[j])/sigmaAfter[j] << '\n';
        }
    }
}


//- A picture to be drawn in a folder by a script of etc/misfit with these variables
figure withScript
(
    const fileName& folder,
    const figure::subject shows,
    const std::string& name,
    const std::string& variables
)
{
    const word script(shows == figure::subject::map ? "map.gp" : "series.gp");
    std::ofstream(folder/name + ".gp") << variables << templateText(script);
    return {shows, folder/(name + ".png"), -1};
}


//- What is given as the answer changes the simulation
bool hasFinding(const finding& f)
{
    return
        f.correction.after.size()
     || (
            f.verdict.kind != verdictKind::none
         && f.verdict.kind != verdictKind::unknown
        );
}


figure ofHeldOut(const finding& f, const label i, const fileName& folder)
{
    const heldOut& h = f.held()[i];
    const std::string name("heldOut" + std::to_string(i + 1));
    writeSeries(folder/name + ".dat", h.data, h.sigma, h.before, h.after);
    figure made
    (
        withScript
        (
            folder, figure::subject::heldOut, name,
            seriesVariables(h.data, name, hasFinding(f))
        )
    );
    made.held = i;
    return made;
}


figure ofFitted(const finding& f, const fileName& folder)
{
    const stacked& data = f.detection.data;
    const decision& verdict = f.verdict;
    writeSeries
    (
        folder/"fitted.dat", data, verdict.sigma, verdict.before, verdict.after
    );
    return withScript
    (
        folder, figure::subject::fitted, "fitted",
        seriesVariables(data, "fitted", hasFinding(f))
    );
}


//- The misfit of all channels of these experiments, a row each
figure ofMap(const finding& f, const fileName& folder)
{
    const misfitDetection& fitted = f.detection;
    const decision& verdict = f.verdict;
    label row = 0;
    std::ostringstream rows;
    std::ofstream map(folder/"map.dat");
    const auto nameRows = [&](const stacked& data, const string& mark)
    {
        for (const segment& s : data.segments)
        {
            rows << "Name[" << ++row << "] = '" << s.name << mark << "'\n";
        }
    };
    writeMap
    (
        map, fitted.data, fitted.sigma, verdict.sigma, verdict.before, verdict.after, row
    );
    nameRows(fitted.data, "");
    for (const heldOut& h : f.held())
    {
        if (h.isHere() || h.what == heldOut::part::testElsewhere)
        {
            writeMap(map, h.data, h.sigma, h.sigma, h.before, h.after, row);
            nameRows(h.data, " (" + purposeNames[h.use] + ")");
        }
    }
    return withScript
    (
        folder, figure::subject::map, "map",
        "found = " + std::to_string(hasFinding(f)) + "; n = " + std::to_string(row)
      + "\narray Name[n]\n" + rows.str()
    );
}


bool gnuplot(const fileName& folder, const std::string& name)
{
    return
        Foam::system
        (
            "cd '" + folder + "' && gnuplot " + name + ".gp >" + name
          + ".log 2>&1"
        ) == 0;
}

} // End anonymous namespace


std::vector<Foam::misfit::figure> Foam::misfit::drawFigures
(
    const finding& f,
    const fileName& folder
)
{
    mkDir(folder);
    std::vector<figure> figures;
    forAll(f.held(), i)
    {
        figures.push_back(ofHeldOut(f, i, folder));
    }
    figures.push_back(ofFitted(f, folder));
    figures.push_back(ofMap(f, folder));

    std::vector<figure> drawn;
    for (const figure& one : figures)
    {
        const std::string name(one.file.nameLessExt());
        if (gnuplot(folder, name))
        {
            drawn.push_back(one);
        }
        else
        {
            Info<< "    gnuplot could not draw " << name.c_str() << "; see "
                << (folder/(name + ".log")).c_str() << endl;
        }
    }
    return drawn;
}
