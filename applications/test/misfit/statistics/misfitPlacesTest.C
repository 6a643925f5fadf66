// SPDX-License-Identifier: GPL-3.0-or-later
// Where a misfit is, and what a Gaussian process learns of it.

#include "gaussianProcess.H"
#include "scalarList.H"
#include "statisticsNames.H"

#include <gtest/gtest.h>

#include <random>

using namespace Foam;
using namespace Foam::misfit;

namespace
{

//- Channels of 20 samples, 0.1 s long, the places 1 m apart
stacked channels(const label n)
{
    stacked data;
    for (label i = 0; i < n; ++i)
    {
        segment s;
        s.name = "S" + Foam::name(i + 1);
        s.quantity = "pressure";
        s.first = 20*i;
        s.size = 20;
        s.x = vec::LinSpaced(20, 0.05, 1.95);
        s.span = 0.1;
        s.readings = vec::Ones(20);
        s.uncertainty = 1;
        s.hasPlace = true;
        s.place = Eigen::Vector3d(i, 0, 0);
        data.segments.push_back(s);
    }
    data.y = vec::Zero(20*n);
    return data;
}


vec hump(const stacked& data, const scalar height)
{
    vec y = vec::Zero(data.size());
    for (const segment& s : data.segments)
    {
        s.of(y) = height*(-(s.x.array() - 1).square()/0.08).exp();
    }
    return y;
}

} // End anonymous namespace


TEST(misfitStretches, aHumpIsOneStretchWithItsLengthAndSign)
{
    const stacked data(channels(2));
    vec misfit = vec::Zero(40);
    misfit.segment(25, 6).setConstant(-3);
    misfit[28] = -1;
    const std::vector<window> found
    (
        statistics::stretches(data, misfit, mat::Identity(40, 40), 2)
    );
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found[0].segment, 1);
    EXPECT_EQ(found[0].begin, 5);
    EXPECT_EQ(found[0].end, 11);
    EXPECT_NEAR(found[0].size, -16/std::sqrt(6.0), 1e-12);
}


TEST(misfitStretches, theSignAndALongGapDivide)
{
    const stacked data(channels(1));
    vec misfit = vec::Zero(20);
    misfit.segment(2, 3).setConstant(4);
    misfit.segment(5, 3).setConstant(-4);
    misfit.segment(11, 2).setConstant(-5);
    EXPECT_EQ(statistics::stretches(data, misfit, mat::Identity(20, 20), 2).size(), 3);
}


TEST(misfitStretches, aSingleSampleMustBeFurtherOff)
{
    const stacked data(channels(1));
    vec misfit = vec::Zero(20);
    misfit[7] = 2.5;
    EXPECT_TRUE(statistics::stretches(data, misfit, mat::Identity(20, 20), 2).empty());
    misfit[7] = 3.5;
    EXPECT_EQ(statistics::stretches(data, misfit, mat::Identity(20, 20), 2).size(), 1);
}


TEST(misfitScan, aShapeThatIsLookedForIsSeenWhereNoWindowSeesIt)
{
    const stacked data(channels(10));
    const whitener white(mat::Identity(200, 200));
    vec shape(200);
    for (label i = 0; i < 200; ++i)
    {
        shape[i] = i % 2 ? 1 : -1;
    }
    const vec misfit = 5*shape.normalized();
    EXPECT_GT(statistics::scan(data, white, 1000, 1)(misfit, 0.05).p, 0.05);
    EXPECT_LT(statistics::scan(data, white, 1000, 1, shape)(misfit, 0.05).p, 0.01);
}


TEST(misfitScan, shapesMakeNoMoreFalseAlarms)
{
    const stacked data(channels(3));
    const whitener white(mat::Identity(60, 60));
    std::mt19937 generator(3);
    std::normal_distribution<scalar> normal;
    mat shapes(60, 20);
    for (scalar& x : shapes.reshaped())
    {
        x = normal(generator);
    }
    const statistics::scan scanning(data, white, 500, 1, shapes);
    label alarms = 0;
    for (label n = 0; n < 400; ++n)
    {
        vec misfit(60);
        for (scalar& x : misfit)
        {
            x = normal(generator);
        }
        alarms += scanning(misfit, 0.05).p < 0.05;
    }
    EXPECT_LT(alarms, 35);
}


TEST(misfitGaussianProcess, aSmoothMisfitIsLearntAndNoiseIsNot)
{
    stacked data(channels(3));
    data.y = 10*vec::Ones(60) + hump(data, 20);
    const vec misfit = hump(data, 20);
    const statistics::gaussianProcess learnt(data, misfit, mat::Identity(60, 60));
    EXPECT_LT((learnt(data) - misfit).norm(), 0.1*misfit.norm());

    const statistics::gaussianProcess nothing(data, vec::Zero(60), mat::Identity(60, 60));
    EXPECT_LT(nothing(data).norm(), 1e-12);
}


TEST(misfitGaussianProcess, aChannelBetweenTwoIsExpectedToDoAsThey)
{
    stacked data(channels(3));
    data.y = hump(data, 20);
    stacked between(channels(1));
    between.segments[0].place = Eigen::Vector3d(0.5, 0, 0);
    const statistics::gaussianProcess learnt(data, data.y, mat::Identity(60, 60));
    const vec there = hump(between, 20);
    EXPECT_LT((learnt(between) - there).norm(), 0.2*there.norm());
}


TEST(misfitGaussianProcess, anotherQuantityIsNotTouched)
{
    stacked data(channels(2));
    data.y = hump(data, 20);
    stacked level(channels(1));
    level.segments[0].quantity = "length";
    const statistics::gaussianProcess learnt(data, data.y, mat::Identity(40, 40));
    EXPECT_EQ(learnt(level).norm(), 0);
}
