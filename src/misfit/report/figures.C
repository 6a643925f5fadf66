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


Foam::List<Foam::fileName> Foam::misfit::drawFigures
(
    const finding& f,
    const fileName& folder
)
{
    mkDir(folder);
    const bool hasFinding =
        f.correction.after.size()
     || (
            f.verdict.kind != verdictKind::none
         && f.verdict.kind != verdictKind::unknown
        );
    List<std::string> names;
    const auto script = [&]
    (
        const std::string& name, const std::string& variables, const word& file
    )
    {
        std::ofstream(folder/name + ".gp") << variables << templateText(file);
        names.append(name);
    };

    forAll(f.held(), i)
    {
        const heldOut& h = f.held()[i];
        const std::string name("heldOut" + std::to_string(i + 1));
        writeSeries(folder/name + ".dat", h.data, h.sigma, h.before, h.after);
        script(name, seriesVariables(h.data, name, hasFinding), "series.gp");
    }
    const misfitDetection& fitted = f.detection;
    const decision& verdict = f.verdict;
    writeSeries
    (
        folder/"fitted.dat", fitted.data, verdict.sigma, verdict.before, verdict.after
    );
    script("fitted", seriesVariables(fitted.data, "fitted", hasFinding), "series.gp");

    label row = 0;
    std::ostringstream rows;
    std::ofstream map(folder/"map.dat");
    const auto addRows = [&](const stacked& data, const string& mark)
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
    addRows(fitted.data, "");
    for (const heldOut& h : f.held())
    {
        if (h.isHere() || h.what == heldOut::part::testElsewhere)
        {
            writeMap(map, h.data, h.sigma, h.sigma, h.before, h.after, row);
            addRows
            (
                h.data, " (" + purposeNames[h.use] + ")"
            );
        }
    }
    map.close();
    script
    (
        "map",
        "found = " + std::to_string(hasFinding) + "; n = " + std::to_string(row)
      + "\narray Name[n]\n" + rows.str(),
        "map.gp"
    );

    List<fileName> drawn;
    for (const std::string& name : names)
    {
        if (gnuplot(folder, name))
        {
            drawn.append(folder/(name + ".png"));
        }
        else
        {
            Info<< "    gnuplot could not draw " << name.c_str() << "; see "
                << (folder/(name + ".log")).c_str() << endl;
        }
    }
    return drawn;
}
