// SPDX-License-Identifier: GPL-3.0-or-later
// The scores of verdicts on concealed cases, with their intervals.

#include "openedCase.H"
#include "shortNumber.H"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- Standard deviations of an interval of 95 %
const scalar z = 1.96;

//- A value with its interval of 95 %
struct interval
{
    scalar value = 0;

    scalar low = 0;

    scalar high = 0;

    //- The sample is large enough for an interval of 95 %
    bool known = true;
};


//- Of a share where 1 is a hit and 0 none (Wilson 1927, J. Am. Stat. Assoc. 22:209)
interval ofShare(const scalarList& hits)
{
    const scalar n = hits.size();
    const scalar p = sum(hits)/n;
    const scalar middle = (p + z*z/(2*n))/(1 + z*z/n);
    const scalar half = z*std::sqrt(p*(1 - p)/n + z*z/(4.0*n*n))/(1 + z*z/n);
    return
    {
        p, p > 0 ? max(middle - half, 0.0) : 0, p < 1 ? min(middle + half, 1.0) : 1
    };
}


interval ofPercent(const scalarList& hits)
{
    const interval i(ofShare(hits));
    return {100*i.value, 100*i.low, 100*i.high};
}


//- Of a median, by the binomial distribution of the ranks, as a normal one
//  (Conover 1999, Practical Nonparametric Statistics, sect. 3.2)
interval ofMedian(const scalarList& numbers)
{
    scalarList values(numbers);
    std::sort(values.begin(), values.end());
    const label n = values.size();
    const scalar half = 0.5*z*std::sqrt(scalar(n));
    const auto ranked = [&](const scalar rank)
    {
        return values[min(max(label(rank) - 1, label(0)), n - 1)];
    };
    // The least and the largest of five hold the median in 94 of 100 cases
    return
    {
        0.5*(values[(n - 1)/2] + values[n/2]),
        ranked(std::floor(0.5*n - half)),
        ranked(std::ceil(1 + 0.5*n + half)),
        n > 5
    };
}


//- Of a mean of what is never negative, as a normal distribution
interval ofMean(const scalarList& values)
{
    const label n = values.size();
    scalar mean = 0;
    scalar squares = 0;
    for (const scalar v : values)
    {
        mean += v/n;
    }
    for (const scalar v : values)
    {
        squares += sqr(v - mean);
    }
    const scalar half = z*std::sqrt(squares)/max(n, label(2));
    return {mean, max(mean - half, 0.0), mean + half};
}


//- goal: "<= 5" or ">= 90". "short": the value misses it; "shown": so does no
//  value of the interval; "open": reached, but the sample is too small to show it
std::string against(const interval& i, const std::string& goal)
{
    if (goal.empty())
    {
        return "";
    }
    const scalar bound = std::stod(goal.substr(3));
    const bool least = goal[0] == '>';
    const auto reaches = [&](const scalar v)
    {
        return least ? v >= bound : v <= bound;
    };
    return
        !reaches(i.value) ? "short"
      : i.known && reaches(least ? i.low : i.high) ? "shown" : "open";
}


//- What a case adds to a score, if it counts there
using added = std::optional<scalar>;

using Case = const openedCase&;


added where(const bool counts, const scalar value)
{
    return counts ? added(value) : added();
}


//- What is missing is in the library
bool isInside(Case c)
{
    return c.kind == "single" || c.kind == "pair";
}


//- The effect can be seen
bool isStrong(Case c)
{
    return c.SNR >= c.detectableFrom;
}


bool isStrong(Case c, const char* kind)
{
    return c.kind == kind && isStrong(c);
}


bool isOverNoise(Case c)
{
    return c.noiseSNR >= c.detectableFrom;
}


bool isNamed(Case c)
{
    return c.outcome == verdictKind::named;
}


//- What is named is all that it has
bool allNamed(Case c)
{
    return isNamed(c) && c.names == c.truth;
}


//- The first of its mechanisms is in a set of indistinguishable ones
bool hasTruthInSet(Case c)
{
    const auto isIt = [&c](const alternative& a)
    {
        return
            a.channel.empty() && a.mechanisms.size() == 1
         && a.mechanisms.front() == c.truth.front();
    };
    return
        c.outcome == verdictKind::set && c.truth.size()
     && std::any_of(c.alternatives.begin(), c.alternatives.end(), isIt);
}


//- A sensor is faulty, but the verdict names only mechanisms
bool blamesPhysics(Case c)
{
    const auto blamesIt = [&](const alternative& a)
    {
        return a.channel == c.faulty || a.partner == c.faulty;
    };
    return
        isNamed(c)
     || (
            c.outcome == verdictKind::set
         && std::none_of(c.alternatives.begin(), c.alternatives.end(), blamesIt)
        );
}


//- Share of the misfit at these held-out data that is gone [%]; none where there was no
//  misfit to speak of, or nothing was named
added gone(Case c, const json& h)
{
    const scalar before = h["meanSquareBefore"];
    const scalar after = h["meanSquareAfter"];
    return where
    (
        before > 2 && isInside(c) && isNamed(c), 100*(before - after)/(before - 1)
    );
}


//- At the test channels of the experiment that is fitted
added goneAtTest(Case c, const json& held)
{
    for (const json& h : held)
    {
        if (h["experiment"] == "" && h["use"] == purposeNames[purpose::test])
        {
            return gone(c, h);
        }
    }
    return added();
}


//- In experiment C, which was not fitted
added goneInC(Case c, const json& held)
{
    for (const json& h : held)
    {
        if (h["experiment"] == "C")
        {
            return gone(c, h);
        }
    }
    return added();
}


//- A row of the table: of what the cases add that count there
struct score
{
    const char* what;

    const char* goal;

    interval (*summary)(const scalarList&);

    added (*of)(Case);
};


const score scores[] =
{
    {"nulls with another verdict than none [%]", "<= 5", ofPercent, [](Case c)
        { return where(c.kind == "null", !c.right); }},
    {"single: right name where SNR >= 5 [%]", ">= 90", ofPercent, [](Case c)
        { return where(isStrong(c, "single"), allNamed(c)); }},
    {"single: right name where SNR of the noise alone >= 5 [%]", ">= 90", ofPercent,
        [](Case c)
        { return where(c.kind == "single" && isOverNoise(c), allNamed(c)); }},
    {"single: right name or in the set where SNR >= 5 [%]", "", ofPercent, [](Case c)
        { return where(isStrong(c, "single"), allNamed(c) || hasTruthInSet(c)); }},
    {"pair: both named where SNR >= 5 [%]", "", ofPercent, [](Case c)
        { return where(isStrong(c, "pair"), allNamed(c)); }},
    {"pair: right where something is named [%]", "", ofPercent, [](Case c)
        { return where(isStrong(c, "pair") && isNamed(c), c.nothingWrong); }},
    {"a name that is given is right [%]", ">= 98", ofPercent, [](Case c)
        { return where(isNamed(c), c.right); }},
    {"outside the library: unknown where SNR >= 5 [%]", ">= 80", ofPercent, [](Case c)
        { return where(isStrong(c, "outside"), c.right); }},
    {"outside the library: wrongly named [%]", "<= 10", ofPercent, [](Case c)
        { return where(c.kind == "outside", isNamed(c)); }},
    {"physics blamed on a sensor [%]", "", ofPercent, [](Case c)
        { return where(isInside(c) || c.kind == "outside", c.blamesChannel()); }},
    {"sensor fault blamed on physics [%]", "<= 5", ofPercent, [](Case c)
        { return where(c.kind == "sensor", blamesPhysics(c)); }},
    {"sensor fault found in its channel where SNR >= 5 [%]", "", ofPercent, [](Case c)
        { return where(isStrong(c, "sensor"), c.right && c.blamesChannel()); }},
    {"where: overlap F1", ">= 0.85", ofMedian, [](Case c)
        { return isInside(c) && isStrong(c) ? c.overlap : added(); }},
    {"when: onset off by [% of the record]", "<= 5", ofMedian, [](Case c)
        { return isInside(c) && isStrong(c) ? c.onset : added(); }},
    {"size of the effect at the probes off by [%]", "<= 15", ofMedian, [](Case c)
        { return isInside(c) && allNamed(c) ? c.sizeOff : added(); }},
    {"misfit removed at test channels [%]", ">= 70", ofMedian, [](Case c)
        { return goneAtTest(c, c.verdict["heldOut"]); }},
    {"the same by a Gaussian process [%]", "", ofMedian, [](Case c)
        { return goneAtTest(c, c.proof["gaussianProcess"]); }},
    {"misfit removed in experiment C [%]", ">= 50", ofMedian, [](Case c)
        { return goneInC(c, c.verdict["heldOut"]); }},
    {"in C by a Gaussian process [%]", "", ofMedian, [](Case c)
        { return goneInC(c, c.proof["gaussianProcess"]); }},
    // Mean square of confidence less 1 where the verdict is right, less 0 where not
    // (Brier 1950)
    {"Brier score of the confidence", "", ofMean, [](Case c)
        { return added(sqr(c.confidence - c.right)); }}
};

} // End anonymous namespace


std::string Foam::misfit::scoresOf(const std::vector<openedCase>& cases)
{
    std::string text("score,value,low,high,cases,goal,says\n");
    for (const score& s : scores)
    {
        scalarList numbers;
        for (const openedCase& c : cases)
        {
            if (const added number = s.of(c))
            {
                numbers.append(*number);
            }
        }
        const label n = numbers.size();
        const interval i(n ? s.summary(numbers) : interval());
        const std::string values
        (
            shortNumber(i.value) + ',' + shortNumber(i.low) + ',' + shortNumber(i.high)
        );
        text +=
            s.what + (',' + (n ? values : ",,")) + ',' + std::to_string(n) + ','
          + s.goal + ',' + (n ? against(i, s.goal) : "") + '\n';
    }
    return text;
}


std::string Foam::misfit::reliabilityOf(const std::vector<openedCase>& cases)
{
    std::ostringstream os;
    os << "from,to,cases,confidence,right,low,high\n";
    for (label i = 0; i < 10; ++i)
    {
        scalarList right;
        scalar confidence = 0;
        for (const openedCase& c : cases)
        {
            if (min(label(10*c.confidence), 9) == i)
            {
                right.append(c.right);
                confidence += c.confidence;
            }
        }
        const label n = right.size();
        os << i*0.1 << ',' << (i + 1)*0.1 << ',' << n << ',';
        if (n)
        {
            const interval share(ofShare(right));
            os << confidence/n << ',' << share.value << ',' << share.low << ','
                << share.high << '\n';
        }
        else
        {
            os << ",,,\n";
        }
    }
    return os.str();
}
