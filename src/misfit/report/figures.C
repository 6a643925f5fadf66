// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of a report, drawn by gnuplot.

#include "report.H"
#include "units.H"

#include "OSspecific.H"

#include <cmath>
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


//- A number alone: recorded with 2 sigma, base and what was found side by side
std::string numberPlot
(
    const segment& s,
    const label i,
    const std::string& file,
    const bool found
)
{
    std::ostringstream os;
    os  << "set title '" << s.name << " (" << s.quantity << ")'\n"
        << "set xlabel ''; set xrange [-0.5:" << (found ? 2.5 : 1.5) << "]\n"
        << "set xtics ('recorded' 0, 'base' 1, 'found' 2)\n"
        << "set ylabel '" << unitOf(s.quantity) << "'\nplot '" << file
        << ".dat' index " << i << " using (0):2:(2*$3) with yerrorbars"
        << " pointtype 7 linecolor 'black',"
        << " '' index " << i << " using (1):4 with points pointtype 9"
        << " pointsize 2 linecolor 'blue'";
    if (found)
    {
        os  << ", '' index " << i << " using (2):5 with points pointtype 9"
            << " pointsize 2 linecolor 'red'";
    }
    os << '\n';
    return os.str();
}


//- Distance of three to eight labels along an axis of that length: gnuplot's own overlap
//  in three columns
scalar labelStep(const scalar length)
{
    const scalar step = max(length, VSMALL)/4;
    const scalar power = std::pow(10.0, std::floor(std::log10(step)));
    const scalar first = step/power;
    return power*(first < 1.5 ? 1 : first < 3.5 ? 2 : first < 7.5 ? 5 : 10);
}


//- A picture of the channels of a file, in columns
std::string seriesPlot
(
    const stacked& data,
    const std::string& file,
    const bool found
)
{
    const label n = data.segments.size();
    const label columns = n < 2 ? 1 : n < 5 ? 2 : 3;
    const label rows = (n + columns - 1)/columns;
    std::ostringstream os;
    os  << "set terminal pngcairo size " << 1100 << ',' << 80 + 270*rows
        << " noenhanced font ',11'\n"
        << "set output '" << file << ".png'\n"
        << "set multiplot layout " << rows << ',' << columns
        << " title 'points: recorded; grey: uncertain (2 sigma); blue, dashed:"
        << " calibrated base" << (found ? "; red: with what was found" : "")
        << "'\n"
        << "set style fill transparent solid 0.35 noborder; unset key\n";
    for (label i = 0; i < n; ++i)
    {
        const segment& s = data.segments[i];
        if (s.isNumber())
        {
            os << numberPlot(s, i, file, found);
            continue;
        }
        os  << "set title '" << s.name << " (" << s.quantity << ")'\n"
            << "set autoscale x; set xtics " << labelStep(s.duration())
            << "; set xlabel '"
            << (s.overTime ? "time [s]" : "distance [m]")
            << "'\nset ylabel '" << unitOf(s.quantity) << "'\nplot '" << file
            << ".dat' index " << i << " using 1:($2-2*$3):($2+2*$3) with"
            << " filledcurves linecolor 'gray',"
            << " '' index " << i << " using 1:2 with points pointtype 7"
            << " pointsize 0.5 linecolor 'black',"
            << " '' index " << i << " using 1:4 with lines linewidth 2"
            << " dashtype 2 linecolor 'blue'";
        if (found)
        {
            os  << ", '' index " << i << " using 1:5 with lines linewidth 2"
                << " linecolor 'red'";
        }
        os << '\n';
    }
    os << "unset multiplot\n";
    return os.str();
}


//- Boxes of the misfit over its deviation: x from to, row, before, after
void writeMap
(
    std::ostream& os,
    const stacked& data,
    const vec& sigma,
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
                << (data.y[j] - before[j])/sigma[j] << ' '
                << (data.y[j] - after[j])/sigma[j] << '\n';
        }
    }
}


//- found: there is a second picture, with what was found
std::string mapPlot
(
    const std::string& names,
    const label rows,
    const bool found
)
{
    std::ostringstream os;
    os  << "set terminal pngcairo size 1100," << 140 + 50*rows
        << " noenhanced font ',11'\n"
        << "set output 'map.png'\n"
        << "set multiplot layout 1," << (found ? 2 : 1) << '\n'
        << "set palette defined (-6 'blue', 0 'white', 6 'red')\n"
        << "set cbrange [-6:6]; set cblabel 'recorded - simulated [sigma]'\n"
        << "set ytics (" << names << "); set yrange [" << rows - 0.5
        << ":-0.5]\n"
        << "set xlabel 'time [s] or distance [m]'; unset key\n"
        << "set style fill solid noborder\n";
    for (const char* panel : {"4 calibrated base", "5 with what was found"})
    {
        if (panel[0] == '5' && !found)
        {
            break;
        }
        os  << "set title '" << panel + 2 << "'\n"
            << "plot 'map.dat' using (0.5*($1+$2)):3:1:2:($3-0.42):($3+0.42):"
            << panel[0] << " with boxxyerror linecolor palette\n";
    }
    os << "unset multiplot\n";
    return os.str();
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


std::string Foam::misfit::unitOf(const word& quantity)
{
    const word unit(siUnit(quantity));
    return unit.empty() ? "" : '[' + unit + ']';
}


Foam::List<Foam::fileName> Foam::misfit::drawFigures
(
    const finding& f,
    const fileName& folder
)
{
    mkDir(folder);
    const bool found =
        f.correction.after.size()
     || (
            f.verdict != verdictKind::none
         && f.verdict != verdictKind::unknown
        );
    List<std::string> names;
    const auto script = [&](const std::string& name, const std::string& text)
    {
        std::ofstream(folder/name + ".gp") << text;
        names.append(name);
    };

    forAll(f.held, i)
    {
        const heldOut& h = f.held[i];
        const std::string name("heldOut" + std::to_string(i + 1));
        writeSeries(folder/name + ".dat", h.data, h.sigma, h.before, h.after);
        script(name, seriesPlot(h.data, name, found));
    }
    writeSeries(folder/"fitted.dat", f.data, f.sigma, f.before, f.after);
    script("fitted", seriesPlot(f.data, "fitted", found));

    label row = 0;
    std::ostringstream rows;
    std::ofstream map(folder/"map.dat");
    const auto addRows = [&](const stacked& data, const string& mark)
    {
        for (const segment& s : data.segments)
        {
            rows << (row ? ", '" : "'") << s.name << mark << "' " << row;
            ++row;
        }
    };
    writeMap(map, f.data, f.sigma, f.before, f.after, row);
    addRows(f.data, "");
    for (const heldOut& h : f.held)
    {
        if (h.isHere() || h.what == heldOut::part::testElsewhere)
        {
            writeMap(map, h.data, h.sigma, h.before, h.after, row);
            addRows
            (
                h.data, " (" + purposeNames[h.use] + ")"
            );
        }
    }
    map.close();
    script("map", mapPlot(rows.str(), row, found));

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
