// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses parameters of a case by response surfaces fitted to runs that are done.

#include "calibration.H"
#include "keywords.H"
#include "numberTable.H"
#include "statisticsNames.H"

#include "argList.H"
#include "scalarField.H"
#include "IFstream.H"
#include "OFstream.H"
#include "serialTool.H"

#include <algorithm>

namespace Foam::misfit
{

using statistics::calibration;
using statistics::calibrationTarget;
using statistics::freeParameter;
using statistics::responseSurface;

freeParameter readParameter(const word& name, const dictionary& dict)
{
    keywords::check(dict, {"bounds", "levels", "scale"});

    freeParameter p;
    p.name = name;
    p.logarithmic =
        keywords::choice
        (
            dict, "scale", "scale of a parameter", {"linear", "log"}, "linear"
        ) == "log";

    scalarField range(dict.lookupOrDefault("levels", scalarList()));
    for (const scalar level : range)
    {
        p.levels.push_back(p.scaled(level));
    }
    if (range.empty())
    {
        range = scalarField(dict.get<scalarList>("bounds"));
    }
    if (range.size() < 2 || min(range) == max(range) || (p.logarithmic && min(range) <= 0))
    {
        FatalIOErrorInFunction(dict)
            << "Parameter " << name << " needs two bounds, or two levels or more, that"
            << " differ" << (p.logarithmic ? " and are above zero" : "")
            << ", and has " << range << exit(FatalIOError);
    }
    p.lower = p.scaled(min(range));
    p.upper = p.scaled(max(range));
    return p;
}


//- Columns of a table, a row of the matrix for each
mat columns(const numberTable& table, const wordList& names)
{
    const label n = table.rows.size();
    mat result(names.size(), n);
    forAll(names, i)
    {
        const scalarList column = table.column(table.find(names[i]));
        result.row(i) = Eigen::Map<const vec>(column.cdata(), n).transpose();
    }
    return result;
}


//- Runs of one kind, the surface that they make, and what it shall come to
class experiment
{
public:

    const word name;

    const wordList conditions;

    const wordList quantities;

    //- Share of the wanted value that counts as one standard deviation
    const scalarField shares;

    label nRuns = 0;

    std::shared_ptr<const responseSurface> surface;

    std::vector<calibrationTarget> targets;

    //- Conditions to predict for, a column for each
    mat others;


    experiment
    (
        const word& name_,
        const dictionary& dict,
        const std::vector<freeParameter>& parameters
    )
    :
        name(name_),
        conditions(dict.lookupOrDefault("conditions", wordList())),
        quantities(dict.get<wordList>("quantities")),
        shares(dict.get<scalarList>("deviations"))
    {
        keywords::check
        (
            dict,
            {
                "runs", "conditions", "mixed", "quantities", "deviations",
                "targets", "predict"
            }
        );
        if (shares.size() != quantities.size() || !shares.size() || min(shares) <= 0)
        {
            FatalIOErrorInFunction(dict)
                << name << ": as many deviations, above zero, as quantities are needed;"
                << " there are " << shares.size() << " of " << quantities.size()
                << exit(FatalIOError);
        }
        makeSurface(csvTable(dict.get<fileName>("runs")), parameters, dict);
        readTargets(csvTable(dict.get<fileName>("targets")));
        if (dict.found("predict"))
        {
            others = columns(csvTable(dict.get<fileName>("predict")), conditions);
        }
    }


    //- Of each variable, whether mixed terms may have it
    static std::vector<bool> mayMix
    (
        const wordList& variables,
        const dictionary& dict
    )
    {
        const bool all = !dict.found("mixed");
        const wordRes mixed(keywords::patterns(dict, "mixed", variables));
        std::vector<bool> result;
        for (const word& name : variables)
        {
            result.push_back(all || mixed.match(name));
        }
        return result;
    }


    void makeSurface
    (
        const numberTable& runs,
        const std::vector<freeParameter>& parameters,
        const dictionary& dict
    )
    {
        wordList names(conditions);
        for (const freeParameter& p : parameters)
        {
            names.append(p.name);
        }
        nRuns = runs.rows.size();
        if (nRuns <= names.size())
        {
            FatalIOErrorInFunction(dict)
                << name << ": " << nRuns << " runs in " << runs.file
                << " do not tell " << names.size() << " variables apart: one more than"
                << " variables at least" << exit(FatalIOError);
        }

        surface = statistics::surfaceOf
        (
            columns(runs, names), columns(runs, quantities), parameters,
            mayMix(names, dict)
        );
    }


    void readTargets(const numberTable& table)
    {
        const mat under = columns(table, conditions);
        const mat wanted = columns(table, quantities);
        const Eigen::Map<const vec> share(shares.cdata(), shares.size());
        for (label i = 0; i < wanted.cols(); ++i)
        {
            for (label q = 0; q < quantities.size(); ++q)
            {
                if (wanted(q, i) == 0)
                {
                    FatalErrorInFunction
                        << "The target of " << quantities[q] << " in " << table.file
                        << " is 0, and its deviation, a fraction of it, would be 0,"
                        << " too. Give a small value instead, and in deviations its"
                        << " standard deviation as a multiple of that value"
                        << exit(FatalError);
                }
            }
            calibrationTarget t;
            t.surface = surface;
            t.conditions = under.col(i);
            t.wanted = wanted.col(i);
            t.deviation = t.wanted.cwiseAbs().cwiseProduct(share);
            targets.push_back(t);
        }
    }


    //- How far the runs check the surface
    void printFreedom() const
    {
        const auto& leverage = surface->leverage().array();
        const label bound = (leverage >= responseSurface::fixesTerm).count();
        Info<< name << ": " << nRuns << " runs, surface of " << surface->nTerms()
            << " terms, " << nRuns - surface->nTerms()
            << " degrees of freedom left, largest leverage of a run "
            << leverage.maxCoeff() << nl;
        if (bound)
        {
            Info<< "    " << bound << " runs have a leverage of "
                << responseSurface::fixesTerm << " or more: the surface goes through"
                << " them whatever they came to, and they tell nothing of its error."
                << " More runs, or fewer variables in mixed" << nl;
        }
    }


    //- Conditions in words, as "D 0.02 M 185"
    string describe(const vec& values) const
    {
        string text;
        forAll(conditions, i)
        {
            text +=
                (i ? " " : "") + conditions[i] + " " + Foam::name(values[i]);
        }
        return text;
    }


    //- Root mean square of the errors at runs left out [unit of the quantity]; none
    //  where there are as many terms as runs
    string leftOut(const label quantity) const
    {
        const mat& errors = surface->leftOut();
        return
            errors.cols()
          ? Foam::name(std::sqrt(errors.row(quantity).squaredNorm()/errors.cols()))
          : string("none");
    }
};


//- Lines of the table of what was predicted
void printPredictions(Ostream& os, const experiment& e, const vec& parameters)
{
    const auto line =
        [&](const char* what, const vec& conditions, const label q, const string& wanted)
    {
        os  << what << ',' << e.name << ',' << e.describe(conditions).c_str() << ','
            << e.quantities[q] << ',' << wanted.c_str() << ','
            << calibration::predicted(*e.surface, conditions, parameters)[q] << ','
            << e.leftOut(q).c_str() << nl;
    };

    forAll(e.quantities, q)
    {
        for (const calibrationTarget& t : e.targets)
        {
            line("target", t.conditions, q, Foam::name(t.wanted[q]));
        }
        for (label i = 0; i < e.others.cols(); ++i)
        {
            line("predicted", e.others.col(i), q, "");
        }
    }
}

} // End namespace Foam::misfit


int main(int argc, char* argv[])
{
    using namespace Foam;
    using namespace Foam::misfit;

    argList::addNote
    (
        "Choose parameters by response surfaces of runs that are done. See README.md"
        " beside the source."
    );
    argList::noParallel();
    argList::addArgument("dictionary");

    startSerialTool();
    const argList args(argc, argv);
    const fileName file(args[1]);
    IFstream is(file);
    if (!is.good())
    {
        FatalErrorInFunction << "Cannot read " << file << exit(FatalError);
    }
    const dictionary dict(is);
    keywords::check(dict, {"FoamFile", "parameters", "experiments"});

    std::vector<freeParameter> parameters;
    for (const entry& e : dict.subDict("parameters"))
    {
        parameters.push_back(readParameter(e.keyword(), e.dict()));
    }

    std::vector<experiment> experiments;
    std::vector<calibrationTarget> targets;
    for (const entry& e : dict.subDict("experiments"))
    {
        experiments.emplace_back(e.keyword(), e.dict(), parameters);
        const auto& its = experiments.back().targets;
        targets.insert(targets.end(), its.begin(), its.end());
        experiments.back().printFreedom();
    }

    calibration calibrate(parameters, targets);
    vec chosen;
    vec deviations;
    const fitted best = calibrate.choose(chosen, deviations);
    Info<< "Sum of squares of the misfit " << best.misfit << " of "
        << best.f.size() << " numbers" << nl;

    OFstream os(file.lessExt() + ".csv");
    os  << "what,name,conditions,quantity,wanted,value,error" << nl;
    for (label i = 0; i < count(parameters); ++i)
    {
        const freeParameter& p = parameters[i];
        const bool atBound =
            std::min(chosen[i] - p.lower, p.upper - chosen[i])
          < 1e-6*(p.upper - p.lower);
        const char* how =
            p.levels.size() ? "level" : atBound ? "at a bound" : "free";

        os  << "parameter," << p.name.c_str() << ",," << how << ",," << p.value(chosen[i]) << ','
            << deviations[i] << (p.logarithmic ? " decades" : "") << nl;
        Info<< "    " << p.name.c_str() << ' ' << p.value(chosen[i]) << " (" << how << ')' << nl;
    }
    for (const experiment& e : experiments)
    {
        printPredictions(os, e, chosen);
    }
    Info<< "Written: " << os.name() << endl;
    return os.good() ? 0 : 1;
}
