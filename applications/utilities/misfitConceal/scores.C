// SPDX-License-Identifier: GPL-3.0-or-later
// The scores of verdicts on concealed cases.

#include "scores.H"
#include "interval.H"
#include "report.H"

#include <optional>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- What a case adds to a score, if it counts there
using added = std::optional<scalar>;

using Case = const openedCase&;


added where(const bool counts, const scalar value)
{
    return counts ? added(value) : added();
}


struct score
{
    const char* what;

    const char* goal;

    added (*of)(Case);
};


//- What is missing is in the library
bool isInside(const openedCase& c)
{
    return c.kind() == "single" || c.kind() == "pair";
}


bool isStrong(const openedCase& c, const char* kind)
{
    return c.kind() == kind && c.isStrong();
}


//- Share of the misfit at held-out data that is gone [%]; none where there was no
//  misfit to speak of, or nothing was named
added gone(const openedCase& c, const nlohmann::json& held, const char* what)
{
    for (const nlohmann::json& h : held)
    {
        const scalar before = h["meanSquareBefore"];
        const scalar after = h["meanSquareAfter"];
        if (h["what"] == what && before > 2)
        {
            return where(isInside(c) && c.named(), 100*(before - after)/(before - 1));
        }
    }
    return added();
}


//- Shares: of the cases that count, 1 is a hit
const score shares[] =
{
    {"nulls with another verdict than none [%]", "<= 5", [](Case c)
        { return where(c.kind() == "null", !c.isRight()); }},
    {"single: right name where SNR >= 5 [%]", ">= 90", [](Case c)
        { return where(isStrong(c, "single"), c.allNamed()); }},
    {"single: right name where SNR of the noise alone >= 5 [%]", ">= 90", [](Case c)
        { return where(c.kind() == "single" && c.isOverNoise(), c.allNamed()); }},
    {"single: right name or in the set where SNR >= 5 [%]", "", [](Case c)
        { return where(isStrong(c, "single"), c.allNamed() || c.hasTruthInSet()); }},
    {"pair: both named where SNR >= 5 [%]", "", [](Case c)
        { return where(isStrong(c, "pair"), c.allNamed()); }},
    {"pair: right where something is named [%]", "", [](Case c)
        { return where(isStrong(c, "pair") && c.named(), c.nothingWrong()); }},
    {"a name that is given is right [%]", ">= 98", [](Case c)
        { return where(c.named(), c.isRight()); }},
    {"outside the library: unknown where SNR >= 5 [%]", ">= 80", [](Case c)
        { return where(isStrong(c, "outside"), c.isRight()); }},
    {"outside the library: wrongly named [%]", "<= 10", [](Case c)
        { return where(c.kind() == "outside", c.named()); }},
    {"physics blamed on a sensor [%]", "", [](Case c)
        { return where(isInside(c) || c.kind() == "outside", c.blamesChannel()); }},
    {"sensor fault blamed on physics [%]", "<= 5", [](Case c)
        { return where(c.kind() == "sensor", c.blamesPhysics()); }},
    {"sensor fault found in its channel where SNR >= 5 [%]", "", [](Case c)
        { return where(isStrong(c, "sensor"), c.isRight() && c.blamesChannel()); }}
};


//- Of these numbers the medians
const score medians[] =
{
    {"where: overlap F1", ">= 0.85", [](Case c)
        { return isInside(c) && c.isStrong() ? c.overlap() : added(); }},
    {"when: onset off by [% of the record]", "<= 5", [](Case c)
        { return isInside(c) && c.isStrong() ? c.onset() : added(); }},
    {"size of the effect at the probes off by [%]", "<= 15", [](Case c)
        { return isInside(c) && c.allNamed() ? c.sizeOff() : added(); }},
    {"misfit removed at test channels [%]", ">= 70", [](Case c)
        { return gone(c, c.verdict["heldOut"], "test channels"); }},
    {"the same by a Gaussian process [%]", "", [](Case c)
        { return gone(c, c.proof["gaussianProcess"], "test channels"); }},
    {"misfit removed in experiment C [%]", ">= 50", [](Case c)
        { return gone(c, c.verdict["heldOut"], "experiment C"); }},
    {"in C by a Gaussian process [%]", "", [](Case c)
        { return gone(c, c.proof["gaussianProcess"], "experiment C"); }}
};


scalarList numbersOf(const score& one, const std::vector<openedCase>& cases)
{
    scalarList numbers;
    for (const openedCase& c : cases)
    {
        if (const added number = one.of(c))
        {
            numbers.append(*number);
        }
    }
    return numbers;
}


std::string row(const char* what, const interval& i, const std::string& goal)
{
    const std::string numbers
    (
        i.n
      ? shortNumber(i.value) + ',' + shortNumber(i.low) + ',' + shortNumber(i.high)
      : std::string(",,")
    );
    return
        what + (',' + numbers) + ',' + std::to_string(i.n) + ',' + goal + ','
      + against(i, goal) + '\n';
}

} // End anonymous namespace


std::string Foam::misfit::scoresOf(const std::vector<openedCase>& cases)
{
    std::string text("score,value,low,high,cases,goal,says\n");
    for (const score& s : shares)
    {
        const scalarList hits(numbersOf(s, cases));
        interval i(ofShare(label(sum(hits)), hits.size()));
        for (scalar* x : {&i.value, &i.low, &i.high})
        {
            *x *= 100;
        }
        text += row(s.what, i, s.goal);
    }
    for (const score& s : medians)
    {
        text += row(s.what, ofMedian(numbersOf(s, cases)), s.goal);
    }

    // Mean square of confidence less 1 where the verdict is right, less 0 where not
    // (Brier 1950)
    scalarList squares;
    for (const openedCase& c : cases)
    {
        squares.append(sqr(c.confidence() - c.isRight()));
    }
    return text + row("Brier score of the confidence", ofMean(squares), "");
}


std::string Foam::misfit::reliabilityOf(const std::vector<openedCase>& cases)
{
    std::ostringstream os;
    os << "from,to,cases,confidence,right,low,high\n";
    for (label i = 0; i < 10; ++i)
    {
        label n = 0;
        label right = 0;
        scalar confidence = 0;
        for (const openedCase& c : cases)
        {
            if (min(label(10*c.confidence()), 9) == i)
            {
                ++n;
                right += c.isRight();
                confidence += c.confidence();
            }
        }
        const interval share(ofShare(right, n));
        os << i*0.1 << ',' << (i + 1)*0.1 << ',' << n << ',';
        if (n)
        {
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
