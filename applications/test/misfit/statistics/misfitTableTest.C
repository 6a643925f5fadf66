// SPDX-License-Identifier: GPL-3.0-or-later
// Columns of a table at wrong rows: arrangements of labels, identities, chance.

#include "columnFault.H"
#include "fpeGuard.H"
#include "tableColumns.H"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>

using statistics::columnFault;
using statistics::columnFaultKind;
using statistics::columnFaults;
using statistics::factorialTable;
using statistics::identity;
using statistics::mat;
using statistics::rowSources;
using statistics::vec;

namespace
{

//- Three factors of three levels: 27 rows
mat threeByThree()
{
    mat result(27, 3);
    for (int i = 0; i < 27; ++i)
    {
        result.row(i) << 10*(1 + i/9), 1 + i/3%3, 0.5 + 0.1*(i%3);
    }
    return result;
}


double rounded(const double x, const double digit)
{
    return std::round(x/digit)*digit;
}


//- Columns q, x, y with q = x/sqrt(y), printed to 0.01, 0.01 and 0.001; noise
//  of q as a share of it
mat printedTable(std::mt19937& random, const double noise = 0)
{
    std::uniform_real_distribution<> share(0, 1);
    mat result(27, 3);
    for (int i = 0; i < 27; ++i)
    {
        const double x = rounded(1.5 + share(random), 0.01);
        const double y = rounded(0.05 + 0.1*share(random), 0.001);
        const double q = x/std::sqrt(y)*(1 + noise*(share(random) - 0.5));
        result.row(i) << rounded(q, 0.01), x, y;
    }
    return result;
}


const vec roundings = (vec(3) << 0.005, 0.005, 0.0005).finished();


//- The same, but x and y vary smoothly with the first two labels and a little
//  with the third, as those of a study do
mat smoothTable(std::mt19937& random, const double noise = 0)
{
    std::normal_distribution<> normal(0, 1);
    const mat labels = threeByThree();
    mat result(27, 3);
    for (int i = 0; i < 27; ++i)
    {
        const double a = labels(i, 0)/10 - 1;
        const double b = labels(i, 1) - 1;
        const double c = 10*labels(i, 2) - 5;
        const double scatter = 1 + 0.005*normal(random);
        const double x = rounded((1.5 + 0.3*a + 0.4*b)*scatter, 0.01);
        const double y = rounded(0.06 + 0.03*a + 0.01*b + 0.008*c, 0.001);
        const double q = x/std::sqrt(y)*(1 + noise*normal(random));
        result.row(i) << rounded(q, 0.01), x, y;
    }
    return result;
}


const factorialTable factorial(threeByThree());

constexpr double limit = 1e-3;


//- The rows below each other, from the second line of a file on
statistics::tableRows inLines(const mat& table)
{
    std::vector<int> lines(table.rows());
    std::iota(lines.begin(), lines.end(), 2);
    return {table, lines};
}


//- The best exchange, and whether it is named
struct outcome
{
    columnFault best;

    bool named;
};


outcome outcomeOf(const mat& table, const vec& digits = roundings)
{
    const Foam::fpeGuard guard;
    identity law("q", "x/sqrt(y)");
    const columnFaults faults(factorial, law, inLines(table), digits, 0.01);
    const columnFault best = faults.attempts().front();
    return {best, faults.isLikely(best, limit)};
}


//- Rearranges a column and expects the check to find it
void expectFound(mat table, const int column, std::mt19937& random)
{
    const auto all = factorial.arrangements();
    const rowSources way = factorial.sources(all[random()%all.size()]);
    const vec right = table.col(column);
    table.col(column) = right(statistics::inverse(way));

    const outcome found = outcomeOf(table);
    EXPECT_EQ(found.best.kind, columnFaultKind::labels);
    EXPECT_EQ(found.best.column, column);
    EXPECT_EQ(found.best.match.exact, 27);
    EXPECT_TRUE(found.named) << found.best.chance;
}

} // End anonymous namespace


TEST(misfitTable, arrangementsOfThreeLabelsOfThreeLevelsAreAllOthersOf1296)
{
    const factorialTable table(threeByThree());
    const auto all = table.arrangements();
    EXPECT_EQ(all.size(), 1295u);

    std::set<rowSources> different;
    for (const auto& one : all)
    {
        different.insert(table.sources(one));
    }
    EXPECT_EQ(different.size(), 1295u);
}


TEST(misfitTable, onlyFactorsWithAsManyLevelsAreExchanged)
{
    mat factors(6, 2);
    factors << 1, 1, 1, 2, 1, 3, 2, 1, 2, 2, 2, 3;
    EXPECT_EQ(factorialTable(factors).arrangements().size(), 2u*6u - 1u);
}


TEST(misfitTable, exchangeOfTwoLabelsTakesTheNumberOfTheMirroredRun)
{
    const factorialTable table(threeByThree());
    const statistics::labelArrangement exchanged
    {
        {1, 0, 2}, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}
    };
    const rowSources sources = table.sources(exchanged);

    // Row 3 is (10 2 0.5); (20 1 0.5) is row 9
    EXPECT_EQ(sources[3], 9);
    EXPECT_EQ(sources[9], 3);
    EXPECT_EQ(sources[0], 0);
    EXPECT_EQ(statistics::inverse(sources), sources);
}


TEST(misfitTable, tableWithoutARowForEachCombinationIsRefused)
{
    const mat factors = threeByThree();
    EXPECT_THROW(factorialTable(factors.topRows(26)), std::invalid_argument);

    mat twice = factors;
    twice.row(3) = twice.row(4);
    EXPECT_THROW(factorialTable{twice}, std::invalid_argument);

    // Row 3 is that of 10, 2, 0.5
    const auto output = [](const mat& table)
    {
        try
        {
            const factorialTable refused(table);
        }
        catch (const std::invalid_argument& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(output(twice).find("; 10 2 0.5 has 0"), std::string::npos);
    mat oneMore(28, 3);
    oneMore << factors, factors.row(4);
    EXPECT_NE(output(oneMore).find("; 10 2 0.6 has 2"), std::string::npos);
}


TEST(misfitTable, moreArrangementsThanCanBeTriedAreRefused)
{
    mat factors(64, 2);
    for (int i = 0; i < 64; ++i)
    {
        factors.row(i) << i/8, i%8;
    }
    EXPECT_THROW(factorialTable(factors).arrangements(), std::length_error);
}


TEST(misfitTable, identityHoldsWithinRoundingAndNotBeyond)
{
    identity law("q", "x/y");
    EXPECT_EQ(law.columns(), (std::vector<std::string>{"q", "x", "y"}));

    const vec digits = (vec(3) << 0.005, 0.05, 0.5).finished();
    const auto row = [](const double q, const double x, const double y)
    {
        return (vec(3) << q, x, y).finished();
    };
    EXPECT_DOUBLE_EQ(law.value(row(0, 3, 4)), 0.75);

    // 10.05/1.5 is 6.7, the most that 10.0/2 may have been
    EXPECT_TRUE(law.holds(row(6.70, 10, 2), digits));
    EXPECT_FALSE(law.holds(row(6.71, 10, 2), digits));
}


TEST(misfitTable, formulaThatCannotBeReadIsRefused)
{
    EXPECT_THROW(identity("q", "x/"), std::invalid_argument);
    EXPECT_THROW(identity("q", "2"), std::invalid_argument);
    EXPECT_THROW(identity("q", "q*x"), std::invalid_argument);
}


TEST(misfitTable, anArrangementOfLabelsIsFoundInTablesMadeByChance)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const mat table = printedTable(random);
        expectFound(table, seed%3, random);
    }
}


TEST(misfitTable, aTableThatMissesItsIdentityForAnotherReasonNamesNothing)
{
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        std::mt19937 random(seed);
        EXPECT_FALSE(outcomeOf(printedTable(random, 0.6)).named) << seed;
    }
}


TEST(misfitTable, neighboursThatAreAlikeAreNoEvidenceOfAnExchange)
{
    for (unsigned seed = 1; seed <= 50; ++seed)
    {
        for (const double noise : {0.01, 0.02})
        {
            std::mt19937 random(seed);
            EXPECT_FALSE(outcomeOf(smoothTable(random, noise)).named)
                << "seed " << seed << ", noise " << noise;
        }
    }
}


TEST(misfitTable, twoExchangedLabelsAreFoundInASmoothTable)
{
    const statistics::labelArrangement exchanged
    {
        {1, 0, 2}, {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}}
    };
    const rowSources way = factorial.sources(exchanged);
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        std::mt19937 random(seed);
        mat table = smoothTable(random);
        const vec right = table.col(2);
        table.col(2) = right(way);

        const outcome found = outcomeOf(table);
        EXPECT_TRUE(found.named) << "seed " << seed << ": " << found.best.chance;
        EXPECT_EQ(found.best.column, 2);
        EXPECT_EQ(vec(table.col(2)(found.best.sources)), right);
    }
}


TEST(misfitTable, twoExchangedRowsAreFoundWhereTheIdentityIsSharp)
{
    std::mt19937 random(3);
    mat table(27, 3);
    std::uniform_real_distribution<> share(1, 2);
    for (int i = 0; i < 27; ++i)
    {
        const double x = share(random);
        const double y = share(random);
        table.row(i) << x/std::sqrt(y), x, y;
    }
    std::swap(table(4, 1), table(20, 1));

    const columnFault best =
        outcomeOf(table, vec::Constant(3, 1e-6)).best;
    EXPECT_EQ(best.kind, columnFaultKind::rows);
    EXPECT_EQ(best.column, 1);
    EXPECT_EQ(best.sources[4], 20);
    EXPECT_EQ(best.match.exact, 27);
}


TEST(misfitTable, aRowIsReportedByItsLineInTheFile)
{
    std::istringstream is("q,x\n1,1\n\n0,2\n");
    const statistics::textTable text(is);
    const statistics::tableRows rows{text.columns({"q", "x"}), text.lines};
    EXPECT_EQ(rows.lines, (std::vector<int>{2, 4}));

    identity law("q", "x");
    const factorialTable two((mat(2, 1) << 1, 2).finished());
    try
    {
        columnFaults(two, law, rows, vec::Constant(2, 0.5), 0.01);
        FAIL() << "a quantity of 0 was taken";
    }
    catch (const std::invalid_argument& wrong)
    {
        EXPECT_EQ(std::string(wrong.what()).substr(0, 7), "line 4:");
    }
}


TEST(misfitTable, aRowWithoutADifferenceIsRefused)
{
    std::mt19937 random(1);
    const mat right = printedTable(random);
    for (const auto& [column, value] : {std::pair(0, 0.0), std::pair(2, -0.1)})
    {
        mat table = right;
        table(5, column) = value;
        EXPECT_THROW(outcomeOf(table), std::invalid_argument);
    }
}
