// SPDX-License-Identifier: GPL-3.0-or-later
// Depth of erosion over time by the laws of entrainment, from what was measured at a
// section of a bed.

#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "argList.H"
#include "erosionByLaws.H"
#include "keywords.H"
#include "numberTable.H"
#include "scalarField.H"
#include "series.H"
#include "projectVersion.H"

using namespace Foam;

namespace
{

//- The series that a dictionary names: file, column, factor. Time is in the first
//  column
misfit::series readSeries(const dictionary& dict, const fileName& caseFolder)
{
    keywords::check(dict, {"file", "column", "factor"});

    fileName file(dict.get<fileName>("file"));
    file.expand();
    if (!file.isAbsolute())
    {
        file = caseFolder/file;
    }

    const string column(misfit::columnIn(dict, "column", ""));
    const scalar factor = dict.getOrDefault<scalar>("factor", 1);
    const misfit::numberTable table
    (
        file.hasExt("csv") ? misfit::csvTable(file) : misfit::writtenTable(file)
    );
    const scalarField values(table.column(table.find(column)));
    return misfit::series(table.column(0), factor*values);
}


//- Times at which the laws are evaluated: those of the normal stress, or with
//  timeStep at equal steps, from "from" to "to" [s]
scalarList timesOf(const dictionary& dict, const scalarList& measured)
{
    const scalar from = dict.getOrDefault("from", measured.first());
    const scalar to = dict.getOrDefault("to", measured.last());
    const scalar step = dict.getOrDefault<scalar>("timeStep", 0);
    DynamicList<scalar> times;

    if (step > 0)
    {
        const label n = label((to - from)/step + 1e-6) + 1;
        for (label i = 0; i < n; ++i)
        {
            times.append(from + i*step);
        }
    }
    else
    {
        for (const scalar t : measured)
        {
            if (t >= from && t <= to)
            {
                times.append(t);
            }
        }
    }

    if (times.size() < 2)
    {
        FatalIOErrorInFunction(dict)
            << "Less than two times from " << from << " to " << to
            << " s: those of normalStress go from " << measured.first()
            << " to " << measured.last() << " s." << nl
            << "    Correct from, to and timeStep." << exit(FatalIOError);
    }

    return scalarList(std::move(times));
}


sectionSeries readSection(const dictionary& dict, const fileName& caseFolder)
{
    const dictionary all
    (
        keywords::sub
        (
            dict, "series", {"normalStress", "velocity", "shearStress", "depth"}
        )
    );

    sectionSeries result;
    result.t = timesOf
    (
        dict, readSeries(all.subDict("normalStress"), caseFolder).x
    );

    const auto fill = [&](const word& name, scalarList& values)
    {
        const misfit::series y(readSeries(all.subDict(name), caseFolder));
        if (y.x.last() < result.t.first() || y.x.first() > result.t.last())
        {
            FatalIOErrorInFunction(all)
                << name << " goes from " << y.x.first() << " to " << y.x.last()
                << " s, but the evaluated times go from " << result.t.first() << " to "
                << result.t.last() << " s." << nl
                << "    Correct from and to, or its times. Are they in ms, or by"
                << " another clock?"
                << exit(FatalIOError);
        }
        values.setSize(result.t.size());
        forAll(values, i)
        {
            values[i] = y(result.t[i]);
        }
    };

    fill("normalStress", result.sigma);
    fill("velocity", result.v);
    if (all.found("shearStress"))
    {
        fill("shearStress", result.tau);
    }
    if (all.found("depth"))
    {
        fill("depth", result.depth);
    }

    return result;
}


void writeDepths
(
    const fileName& file,
    const sectionSeries& s,
    const List<erosionByLaws::erosion>& all
)
{
    OFstream os(file);
    os  << "# Shear in Pa, depth of erosion in m by each law, rate of the scouring"
        << " law in m/s; the shear is the measured one, or that of a law\n# Time";

    if (s.depth.size())
    {
        os  << "\tdepth";
    }
    for (const erosionByLaws::erosion& e : all)
    {
        for
        (
            const char* what
          : {"shear", "static", "dynamic", "scouring", "scouringRate"}
        )
        {
            os  << tab << e.shear << ':' << what;
        }
    }
    os  << nl;

    forAll(s.t, i)
    {
        os  << s.t[i];
        if (s.depth.size())
        {
            os  << tab << s.depth[i];
        }
        for (const erosionByLaws::erosion& e : all)
        {
            os  << tab << e.tau[i] << tab << e.byStatic[i] << tab
                << e.byDynamic[i] << tab << e.byScouring[i] << tab
                << e.scouringRate[i];
        }
        os  << nl;
    }
}


//- Depths at the end and mean square errors, for a person and as a table
void writeErrors
(
    const fileName& file,
    const sectionSeries& s,
    const List<erosionByLaws::erosion>& all
)
{
    OFstream os(file);
    const string title
    (
        "Mean square errors against what was measured: depth by each law in m2,"
        " shear in Pa2; -1: not measured"
    );
    os  << "# " << title.c_str()
        << "\n# shear\tstatic\tdynamic\tscouring\tshearError\n";
    Info<< title.c_str() << nl;

    for (const erosionByLaws::erosion& e : all)
    {
        os  << e.shear << tab << e.staticError << tab << e.dynamicError << tab
            << e.scouringError << tab << e.shearError << nl;
        Info<< "shear " << e.shear << ": static " << e.staticError
            << ", dynamic " << e.dynamicError << ", scouring "
            << e.scouringError << "; shear " << e.shearError << nl
            << "    depth at the end: static " << e.byStatic.last()
            << ", dynamic " << e.byDynamic.last() << ", scouring "
            << e.byScouring.last() << " m" << nl;
    }
    if (s.depth.size())
    {
        Info<< "depth at the end, measured: " << s.depth.last() << " m" << nl;
    }
    Info<< endl;
}

} // End anonymous namespace


int main(int argc, char *argv[])
{
    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Depth of erosion over time by the static, dynamic and progressive"
        " scouring law of entrainment, and their errors"
    );
    argList::noParallel();
    argList::addOption
    (
        "dict", "file", "Settings: system/entrainmentLawsDict unless given"
    );
    #include "setRootCase.H"

    fileName path
    (
        args.opt<fileName>("dict", args.path()/"system/entrainmentLawsDict")
    );
    if (!isFile(path))
    {
        FatalErrorInFunction
            << "No settings " << path << nl
            << "    Write them, or name another file with -dict."
            << exit(FatalError);
    }

    IFstream is(path);
    const dictionary dict(is);
    keywords::check
    (
        dict,
        {
            "FoamFile", "name", "series", "from", "to", "timeStep", "slope",
            "gravity", "frictionAngle", "residualFrictionAngle", "bulkDensity",
            "turbulenceCoefficient", "erodibleDepth", "scouring"
        }
    );

    const sectionSeries section(readSection(dict, args.path()));
    const List<erosionByLaws::erosion> all(erosionByLaws(dict).of(section));
    const fileName folder
    (
        args.path()/"postProcessing"
       /dict.getOrDefault<word>("name", "entrainmentLaws")
    );

    mkDir(folder);
    writeDepths(folder/"depths.dat", section, all);
    writeErrors(folder/"errors.dat", section, all);
    Info<< "Written to " << folder << nl << endl;

    return 0;
}
