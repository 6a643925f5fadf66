// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of the columns of a table: comparison with a reference,
// correlations, power laws. A line "name,value" for each number.

#include "argList.H"
#include "powerLawFit.H"
#include "rankCorrelation.H"
#include "tableColumns.H"
#include "wordList.H"
#include "projectVersion.H"

#include <stdexcept>

using namespace Foam;
using statistics::mat;
using statistics::vec;

namespace
{

mat readTable(const fileName& file, const wordList& names)
{
    return statistics::readTable(file).columns({names.begin(), names.end()});
}


//- The names of a pair of columns
wordList pairOf(const argList& args, const word& option)
{
    const wordList names(args.getList<word>(option));
    if (names.size() != 2)
    {
        FatalErrorInFunction
            << "-" << option << " wants two columns, as '(H HPaper)', not "
            << names << exit(FatalError);
    }
    return names;
}


template<class Value>
void print(const char* name, const Value& value)
{
    Info<< name << ',' << value << nl;
}


//- Mean of |x/y - 1| in %
scalar meanAbsoluteDifference(const vec& x, const vec& y)
{
    return 100*(x.array()/y.array() - 1).abs().mean();
}


//- Value and reference; the constant is the mean of all references, also of
//  those without a value. scatter: standard deviation of a value, negative: not
//  known
void compare(const mat& table, const scalar scatter)
{
    const mat pairs = statistics::completeRows(table);
    print("pairs", label(pairs.rows()));
    if (pairs.rows() == 0)
    {
        return;
    }

    const vec x = pairs.col(0);
    const vec y = pairs.col(1);
    if ((y.array() == 0).any())
    {
        throw std::invalid_argument
        (
            "a reference is 0, of which no difference is a share"
        );
    }
    const scalar mean = statistics::completeRows(table.col(1)).mean();
    const scalar off = meanAbsoluteDifference(x, y);
    const scalar constant =
        meanAbsoluteDifference(vec::Constant(y.size(), mean), y);

    print("mean", x.mean());
    print("meanAbsoluteDifference", off);
    print("constantDifference", constant);
    print("skill", 1 - off/constant);
    print("correlation", statistics::correlation(x, y));
    print("rankCorrelation", statistics::rankCorrelation(x, y));

    if (scatter >= 0)
    {
        const statistics::rankInterval interval =
            statistics::rankCorrelationInterval(x, y, scatter);
        print("rankCorrelationFrom", interval.from);
        print("rankCorrelationTo", interval.to);
    }
}


void powerLaw(const mat& table)
{
    const mat pairs = statistics::completeRows(table);
    const statistics::powerLaw law =
        statistics::fitPowerLaw(pairs.col(0), pairs.col(1));

    print("pairs", label(pairs.rows()));
    print("coefficient", law.coefficient);
    print("exponent", law.exponent);
    print("R2", law.R2);
    print("xMin", pairs.col(0).minCoeff());
    print("xMax", pairs.col(0).maxCoeff());
}


//- Each column with each, over the rows in which all are there
void correlations(const wordList& names, const mat& table)
{
    const mat rows = statistics::completeRows(table);
    print("first,second", "correlation");
    forAll(names, i)
    {
        forAll(names, k)
        {
            Info<< names[i] << ',' << names[k] << ','
                << statistics::correlation(rows.col(i), rows.col(k)) << nl;
        }
    }
}


void printAll(const argList& args, const fileName& file)
{
    if
    (
        !args.found("compare")
     && !args.found("powerLaw")
     && !args.found("correlations")
    )
    {
        FatalErrorInFunction
            << "Nothing to compute from " << file << nl
            << "    Add -compare, -powerLaw or -correlations."
            << exit(FatalError);
    }
    if (args.found("compare"))
    {
        compare
        (
            readTable(file, pairOf(args, "compare")),
            args.getOrDefault<scalar>("scatter", -1)
        );
    }
    if (args.found("powerLaw"))
    {
        powerLaw(readTable(file, pairOf(args, "powerLaw")));
    }
    if (args.found("correlations"))
    {
        const wordList names(args.getList<word>("correlations"));
        correlations(names, readTable(file, names));
    }
}

} // End anonymous namespace


int main(int argc, char *argv[])
{
    Foam::answerVersion(argc, argv);
    argList::addNote
    (
        "Statistics of the columns of a table with commas and a line of names:"
        " a line name,value for each number"
    );
    argList::noBanner();
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addArgument("table.csv");
    argList::addOption
    (
        "compare",
        "(x y)",
        "Mean absolute difference of x from the reference y, correlations"
    );
    argList::addOption
    (
        "scatter",
        "number",
        "With -compare: standard deviation of x, for the 90 % interval of the"
        " rank correlation"
    );
    argList::addOption
    (
        "powerLaw", "(x y)", "Fit of y = a x^b by least squares"
    );
    argList::addOption
    (
        "correlations", "(x y ...)", "Correlation of each column with each"
    );
    const argList args(argc, argv);
    Sout.precision(12);

    const fileName file(args[1]);
    try
    {
        printAll(args, file);
    }
    catch (const std::invalid_argument& wrong)
    {
        FatalErrorInFunction
            << "Table " << file << ": " << wrong.what() << exit(FatalError);
    }

    return 0;
}
