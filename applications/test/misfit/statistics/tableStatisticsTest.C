// SPDX-License-Identifier: GPL-3.0-or-later
// Statistics of tables: correlations by value and rank, interval, power laws.

#include "powerLawFit.H"
#include "rankCorrelation.H"
#include "tableColumns.H"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

using statistics::mat;
using statistics::vec;

namespace
{

vec numbers(const std::initializer_list<double>& all)
{
    return Eigen::Map<const vec>(all.begin(), all.size());
}


//- Columns x and y of a table given as text
mat columnsOf(const std::string& text)
{
    std::istringstream is(text);
    return statistics::textTable(is).columns({"x", "y"});
}

} // End anonymous namespace


TEST(tableStatistics, equalValuesShareTheMeanOfTheirRanks)
{
    const vec r = statistics::ranks(numbers({30, 10, 30, 20, 30}));
    EXPECT_EQ(r, numbers({4, 1, 4, 2, 4}));
}


TEST(tableStatistics, correlationIsThatOfThreePointsByHand)
{
    // Deviations (-1 0 1) and (-1 1 0): 1/sqrt(2*2)
    EXPECT_NEAR
    (
        statistics::correlation(numbers({1, 2, 3}), numbers({4, 6, 5})),
        0.5, 1e-14
    );
}


TEST(tableStatistics, aConstantColumnIsNotCorrelated)
{
    EXPECT_EQ
    (
        statistics::correlation(numbers({1, 2, 3}), numbers({5, 5, 5})), 0
    );
}


TEST(tableStatistics, rankCorrelationIsSpearmansSumOfSquares)
{
    // 1 - 6*(1 + 1 + 1 + 1)/(5*24), with ranks 2 1 3 5 4 of the second
    EXPECT_NEAR
    (
        statistics::rankCorrelation
        (
            numbers({1, 2, 3, 4, 5}), numbers({7, 3, 20, 1e6, 400})
        ),
        0.8, 1e-14
    );
}


TEST(tableStatistics, risingCurvesHaveARankCorrelationOfOne)
{
    const vec x = vec::LinSpaced(9, 0.1, 5);
    const vec y = x.array().exp();
    EXPECT_NEAR(statistics::rankCorrelation(x, y), 1, 1e-14);
    EXPECT_NEAR(statistics::rankCorrelation(x, -y), -1, 1e-14);
}


TEST(tableStatistics, withoutScatterTheIntervalIsTheRankCorrelation)
{
    const vec x = numbers({1, 2, 3, 4, 5});
    const vec y = numbers({7, 3, 20, 1e6, 400});
    const auto interval = statistics::rankCorrelationInterval(x, y, 0);
    EXPECT_NEAR(interval.from, 0.8, 1e-14);
    EXPECT_NEAR(interval.to, 0.8, 1e-14);
}


TEST(tableStatistics, theIntervalOfTwoPointsIsTheirTwoOrders)
{
    // With a scatter of their distance, noise exchanges the two in
    // P(N(0,2) > 1) = 24 % of the draws: the correlation is 1 or -1, mirrored
    // about 1 it is 1 or 3, which is cut at 1
    const vec x = numbers({0, 1});
    const auto up = statistics::rankCorrelationInterval(x, x, 1);
    EXPECT_EQ(up.from, 1);
    EXPECT_EQ(up.to, 1);

    // With a hundredth of it never
    const auto down = statistics::rankCorrelationInterval(x, -x, 0.01);
    EXPECT_EQ(down.from, -1);
    EXPECT_EQ(down.to, -1);
}


TEST(tableStatistics, theIntervalLiesOnTheOtherSideOfTheDraws)
{
    // Noise as wide as the points themselves takes a correlation down to
    // 1/sqrt(1 + s^2/var) = 1/sqrt(2) of it, that of the ranks about as much
    const vec x = vec::LinSpaced(1000, 0, 1);
    const double scatter = std::sqrt(1.0/12);
    vec y = x;
    for (int i = 0; i + 1 < y.size(); i += 2)
    {
        // Half of the points at random places of their own, so that the
        // correlation is not cut at 1
        y[i] = std::fmod(0.618033988749895*i, 1.0);
    }
    const double rho = statistics::rankCorrelation(x, y);
    const auto interval =
        statistics::rankCorrelationInterval(x, y, scatter, 100);
    const double middle = 0.5*(interval.from + interval.to);
    EXPECT_GT(interval.from, rho);
    EXPECT_NEAR(middle, rho*(2 - 1/std::sqrt(2.0)), 0.03);
}


TEST(tableStatistics, aPowerLawIsFoundAgain)
{
    const vec x = numbers({228, 300, 410, 555, 700});
    const vec y = 1.7*x.array().pow(0.25);
    const auto law = statistics::fitPowerLaw(x, y);
    EXPECT_NEAR(law.coefficient, 1.7, 1e-6);
    EXPECT_NEAR(law.exponent, 0.25, 1e-7);
    EXPECT_NEAR(law.R2, 1, 1e-12);
}


TEST(tableStatistics, thePowerLawIsByLeastSquaresOfTheValues)
{
    // Two values at each of x = 1 and 4: the law passes through the means, 2
    // and 4, not through the geometric ones. Left are 4 of 8 squares
    const auto law = statistics::fitPowerLaw
    (
        numbers({1, 1, 4, 4}), numbers({1, 3, 3, 5})
    );
    EXPECT_NEAR(law.coefficient, 2, 1e-6);
    EXPECT_NEAR(law.exponent, 0.5, 1e-6);
    EXPECT_NEAR(law.R2, 0.5, 1e-12);
}


TEST(tableStatistics, aPowerLawNeedsPositivePointsAtTwoPlaces)
{
    EXPECT_THROW
    (
        statistics::fitPowerLaw(numbers({0, 1}), numbers({1, 2})),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        statistics::fitPowerLaw(numbers({2, 2}), numbers({1, 2})),
        std::invalid_argument
    );
    EXPECT_THROW(statistics::fitPowerLaw(vec(), vec()), std::invalid_argument);
}


TEST(tableStatistics, rowsWithEmptyCellsAreLeftOutAndWordsElsewhereAreNot)
{
    const mat all =
        columnsOf("run,y,x,output\na,1,2,done\nb,,4,not run\nc,5,6e-1,\n");
    ASSERT_EQ(all.rows(), 3);
    const mat complete = statistics::completeRows(all);
    mat expected(2, 2);
    expected << 2, 1, 0.6, 5;
    EXPECT_EQ(complete, expected);
}


TEST(tableStatistics, aTableThatIsWrongIsAnError)
{
    EXPECT_THROW(columnsOf("x,z\n1,2\n"), std::invalid_argument);
    EXPECT_THROW(columnsOf("x,y\n1,2m\n"), std::invalid_argument);
    EXPECT_THROW(columnsOf("x,y\n1,nan\n"), std::invalid_argument);
    EXPECT_THROW(columnsOf("x,y\n1\n"), std::invalid_argument);
    EXPECT_THROW(columnsOf(""), std::invalid_argument);
    EXPECT_THROW(columnsOf("x;y\n1;2\n"), std::invalid_argument);
}


TEST(tableStatistics, linesOfCommentAreNoRows)
{
    mat expected(1, 2);
    expected << 1, 2;
    EXPECT_EQ(columnsOf("# a table\nx,y\n\n1,2\n# 3,4\n"), expected);
}
