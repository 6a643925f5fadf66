// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses parameters of a case by response surfaces fitted to runs that are done.

#include "calibration.H"
#include "keywords.H"
#include "numberTable.H"
#include "statisticsNames.H"

#include "scalarField.H"
#include "OFstream.H"
#include "projectVersion.H"
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

    scalarField range(dict.getOrDefault("levels", scalarList()));
    for (const scalar level : range)
    {
        p.levels.push_back(p.scaled(level));
    }
    if (range.empty())
    {
        range = scalarField(dict.get<scalarList>("bounds"));
    }
    if
    (
        range.size() < 2 || min(range) == max(range)
     || (p.logarithmic && min(range) <= 0)
    )
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


//- Columns of the table that a keyword names, a row of the matrix for each
mat columns(const dictionary& dict, const word& keyword, const wordList& names)
{
    const numberTable table(csvTable(dict.get<fileName>(keyword)));
    mat result(names.size(), table.rows.size());
    forAll(names, i)
    {
        const scalarList column(table.column(table.find(names[i])));
        result.row(i) =
            Eigen::Map<const vec>(column.cdata(), column.size()).transpose();
    }
    return result;
}


//- Runs of one kind, the surface that they make, and what it shall come to
struct experiment
{
    word name;

    wordList conditions;

    wordList quantities;

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
        conditions(dict.getOrDefault("conditions", wordList())),
        quantities(dict.get<wordList>("quantities"))
    {
        keywords::check
        (
            dict,
            {
                "runs", "conditions", "mixed", "quantities", "deviations",
                "targets", "predict"
            }
        );
        makeSurface(dict, parameters);
        readTargets(dict);
        if (dict.found("predict"))
        {
            others = columns(dict, "predict", conditions);
        }
    }


    void makeSurface
    (
        const dictionary& dict,
        const std::vector<freeParameter>& parameters
    )
    {
        wordList names(conditions);
        for (const freeParameter& p : parameters)
        {
            names.append(p.name);
        }
        const mat variables(columns(dict, "runs", names));
        if (variables.cols() <= names.size())
        {
            FatalIOErrorInFunction(dict)
                << name << ": " << variables.cols() << " runs in "
                << dict.get<fileName>("runs") << " cannot separate " << names.size()
                << " variables: at least one run more than variables is needed"
                << exit(FatalIOError);
        }
        const wordRes mixed(keywords::patterns(dict, "mixed", names));
        std::vector<bool> mayMix;
        for (const word& variable : names)
        {
            mayMix.push_back(!dict.found("mixed") || mixed.match(variable));
        }
        surface = statistics::surfaceOf
        (
            variables, columns(dict, "runs", quantities), parameters, mayMix
        );
    }


    void readTargets(const dictionary& dict)
    {
        // Share of the wanted value that counts as one standard deviation
        const scalarField shares(dict.get<scalarList>("deviations"));
        if (shares.size() != quantities.size() || !shares.size() || min(shares) <= 0)
        {
            FatalIOErrorInFunction(dict)
                << name << ": as many deviations, above zero, as quantities are needed;"
                << " there are " << shares.size() << " of " << quantities.size()
                << exit(FatalIOError);
        }
        const mat under(columns(dict, "targets", conditions));
        const mat measured(columns(dict, "targets", quantities));
        forAll(quantities, q)
        {
            if ((measured.row(q).array() == 0).any())
            {
                FatalIOErrorInFunction(dict)
                    << "The target of " << quantities[q] << " in "
                    << dict.get<fileName>("targets") << " is 0, and its deviation,"
                    << " a fraction of it, would be 0, too. Give a small value"
                    << " instead, and in deviations its standard deviation as a"
                    << " multiple of that value" << exit(FatalIOError);
            }
        }
        const Eigen::Map<const vec> share(shares.cdata(), shares.size());
        const mat deviations(share.asDiagonal()*measured.cwiseAbs());
        for (label i = 0; i < measured.cols(); ++i)
        {
            targets.push_back
            ({
                surface, under.col(i), measured.col(i), deviations.col(i)
            });
        }
    }


    //- How far the runs check the surface
    void printFreedom() const
    {
        const auto& leverage = surface->leverage().array();
        const label nRuns = leverage.size();
        const label bound = (leverage >= responseSurface::fixesTerm).count();
        Info<< name << ": " << nRuns << " runs, surface of " << surface->nTerms()
            << " terms, " << nRuns - surface->nTerms()
            << " degrees of freedom left, largest leverage of a run "
            << leverage.maxCoeff() << nl;
        if (bound)
        {
            Info<< "    " << bound << " runs have a leverage of "
                << responseSurface::fixesTerm << " or more: the surface passes through"
                << " them whatever their results, so they do not show its error."
                << " Add runs, or list fewer variables in mixed" << nl;
        }
    }


    //- Lines of the table of predictions, with the root mean square of the errors at
    //  runs left out [unit of the quantity]; none where there are as many terms as runs
    void print(Ostream& os, const vec& parameters) const
    {
        const mat& left = surface->leftOut();
        const label n = targets.size();
        forAll(quantities, q)
        {
            const string error
            (
                left.cols()
              ? Foam::name(std::sqrt(left.row(q).squaredNorm()/left.cols()))
              : word("none")
            );
            for (label i = 0; i < n + others.cols(); ++i)
            {
                const bool isTarget = i < n;
                const vec under(isTarget ? targets[i].conditions : others.col(i - n));
                os << (isTarget ? "target," : "predicted,") << name << ',';
                forAll(conditions, c)
                {
                    os << (c ? " " : "") << conditions[c] << ' ' << under[c];
                }
                os << ',' << quantities[q] << ',';
                if (isTarget)
                {
                    os << targets[i].values[q];
                }
                os  << ',' << calibration::predicted(*surface, under, parameters)[q]
                    << ',' << error.c_str() << nl;
            }
        }
    }
};

} // End namespace Foam::misfit


int main(int argc, char* argv[])
{
    using namespace Foam;
    using namespace Foam::misfit;

    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Choose parameters by response surfaces of runs that are done. See README.md"
        " beside the source."
    );
    argList::noParallel();
    argList::addArgument("dictionary");
    startSerialTool();
    const argList args(argc, argv);
    const dictionary dict(readArgument(args));
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
    const fitResult best = calibrate.choose(chosen, deviations);
    Info<< "Sum of squares of the misfit " << best.misfit << " of "
        << best.f.size() << " numbers" << nl;

    OFstream os(fileName(args[1]).lessExt() + ".csv");
    os  << "what,name,conditions,quantity,wanted,value,error" << nl;
    for (label i = 0; i < count(parameters); ++i)
    {
        const freeParameter& p = parameters[i];
        const bool atBound =
            std::min(chosen[i] - p.lower, p.upper - chosen[i])
          < 1e-6*(p.upper - p.lower);
        const char* how =
            p.levels.size() ? "level" : atBound ? "at a bound" : "free";
        const scalar value = p.value(chosen[i]);

        os  << "parameter," << p.name.c_str() << ",," << how << ",," << value << ','
            << deviations[i] << (p.logarithmic ? " decades" : "") << nl;
        Info<< "    " << p.name.c_str() << ' ' << value << " (" << how << ')' << nl;
    }
    for (const experiment& e : experiments)
    {
        e.print(os, chosen);
    }
    Info<< "Written: " << os.name() << endl;
    return os.good() ? 0 : 1;
}
