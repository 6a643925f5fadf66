// SPDX-License-Identifier: GPL-3.0-or-later
// Fits the table of confidences to cases whose cause is known.

#include "confidenceFit.H"
#include "tableColumns.H"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- A row of the file: the fit to the cases of one verdict
std::string fittedRow
(
    const verdictKind verdict,
    const std::vector<knownCase>& cases,
    const scalar shrinkage
)
{
    statistics::mat x(0, groundNames.size());
    std::vector<bool> right;
    for (const knownCase& c : cases)
    {
        if (c.verdict == verdict)
        {
            x.conservativeResize(x.rows() + 1, Eigen::NoChange);
            x.bottomRows(1) = c.grounds.transpose();
            right.push_back(c.right);
        }
    }
    if (right.empty())
    {
        FatalErrorInFunction
            << "No case has the verdict " << verdictNames[verdict] << ", so that its"
            << " confidence cannot be fitted: make more cases" << exit(FatalError);
    }
    const statistics::logistic fit
    (
        statistics::fitLogistic(x, right, shrinkage)
    );
    std::ostringstream os;
    os << std::setprecision(4) << '\n' << verdictNames[verdict] << "\n{\n"
        << "    cases       " << right.size() << ";\n"
        << "    right       " << std::count(right.begin(), right.end(), true)
        << ";\n"
        << "    constant    " << fit.constant << ";\n";
    forAll(groundNames, i)
    {
        // Where the data do not determine a coefficient, the fit leaves only rounding
        const scalar least = x.col(i).minCoeff();
        const scalar largest = x.col(i).maxCoeff();
        const bool changes = mag(fit.coefficients[i])*(largest - least) > 1e-6;
        os << "    " << std::left << std::setw(12) << groundNames[i] << '('
            << (changes ? fit.coefficients[i] : 0) << ' ' << least << ' '
            << largest << ");\n";
    }
    os << "}\n";
    return os.str();
}

} // End anonymous namespace


std::vector<Foam::misfit::knownCase>
Foam::misfit::readKnownCases(const fileName& file)
{
    std::ifstream is(file);
    if (!is)
    {
        FatalErrorInFunction
            << "There are no scored cases " << file
            << ": misfitConceal -score writes such a cases.csv" << exit(FatalError);
    }
    std::vector<std::string> names({"right"});
    names.insert(names.end(), groundNames.begin(), groundNames.end());
    std::vector<knownCase> cases;
    try
    {
        const statistics::textTable table(is);
        const statistics::mat numbers = table.whole(names);
        const label verdict = table.find("verdict");
        for (label i = 0; i < numbers.rows(); ++i)
        {
            cases.push_back
            ({
                verdictNames[word(table.rows[i][verdict])],
                numbers.row(i).tail(groundNames.size()).transpose(), numbers(i, 0) > 0.5
            });
        }
    }
    catch (const std::invalid_argument& e)
    {
        FatalErrorInFunction
            << "Confidences cannot be fitted to " << file << ": " << e.what()
            << exit(FatalError);
    }
    return cases;
}


std::string Foam::misfit::fittedTable
(
    const std::vector<knownCase>& cases,
    const scalar shrinkage
)
{
    std::string text
    (
        "// How often verdicts were right in " + std::to_string(cases.size())
      + " cases whose cause was known.\n"
        "// Fitted by misfitConceal -calibrate, whose page says what each number is;"
        " not to be edited.\n"
        "// logit of the probability = constant + sum of coefficient x value. Of each"
        " ground:\n"
        "// (coefficient, least value, largest value); values beyond count as these.\n"
        "\nFoamFile\n{\n    version     2.0;\n    format      ascii;\n"
        "    class       dictionary;\n    object      confidence;\n}\n"
    );
    for (const word& verdict : verdictNames.sortedToc())
    {
        text += fittedRow(verdictNames[verdict], cases, shrinkage);
    }
    return text;
}
