// SPDX-License-Identifier: GPL-3.0-or-later
// A finding in words: the free correction and its laws.

#include "words.H"
#include "report.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- What stands after a coefficient of a push, by function
const stringList pushWords
({
    "times the weight of the water, whatever its velocity",
    "Fr^2 times the weight of the water",
    "Fr^2/Re times the weight of the water",
    "times the solid fraction and the weight of the water"
});


string withDeviation(const scalar value, const scalar deviation)
{
    return shortNumber(value, 3) + " +- " + shortNumber(2*deviation, 3);
}


string ofDrag(const fittedLaw& l)
{
    const wordList groups({"", "Re_p", "voidFraction"});
    string words("the drag times ");
    forAll(l.law.functions, i)
    {
        const label f = l.law.functions[i];
        const scalar c = l.coefficients[i];
        const scalar d = l.deviations[i];
        words += i ? " " : "";
        words +=
            f == 0 ? withDeviation(std::exp(c), std::exp(c)*d)
          : string
            (
                '(' + groups[f] + '/' + shortNumber(l.law.middle[i], 3) + ")^("
              + withDeviation(c, d) + ')'
            );
    }
    return words;
}


string ofPush(const fittedLaw& l)
{
    const bool against =
        l.law.functions.size() == 1 && l.coefficients[0] < 0;
    string words("a force on the water of ");
    forAll(l.law.functions, i)
    {
        const scalar c = (against ? -1 : 1)*l.coefficients[i];
        words +=
            (i ? " plus " : "") + withDeviation(c, l.deviations[i]) + ' '
          + pushWords[l.law.functions[i]];
    }
    return words + (against ? ", against the flow" : ", along the flow");
}


string whyNoLaw(const correctionFound& c)
{
    return
        c.lawThatFails < 0
      ? "No law in one or two dimensionless numbers says as much."
      : "No law is named, since the solver fails with one that may say as much: it"
        " would act like " + describe(c.laws[c.lawThatFails]) + '.';
}


string whyNotNamed(const correctionFound& c)
{
    return
        !c.explained ? whyNoLaw(c)
      : !c.transfers
      ? "This law is not named, since no other experiment confirms it."
      : !c.holds
      ? "This law is not named, since held-out channels are matched worse."
      : "This law is not named, since it leaves too much.";
}


//- What it does to held-out data
string whatIsGone(const correctionFound& c)
{
    string gone;
    string worse;
    for (const heldOut& h : c.held)
    {
        if (h.squareAfter > h.squareBefore)
        {
            worse += (worse.empty() ? "" : " and ") + describe(h);
        }
        else
        {
            gone +=
                (gone.empty() ? "" : ", ")
              + Foam::name(std::round(100*removed(h))) + " % at " + describe(h);
        }
    }
    string words
    (
        c.held.empty()
      ? string(". There are no held-out data to try that on.")
      : gone.empty() ? string(".")
      : ". Of the misfit, this takes away " + gone + '.'
    );
    if (!worse.empty())
    {
        words += " It does not hold at " + worse + '.';
    }
    return words;
}

} // End anonymous namespace


Foam::string Foam::misfit::describe(const fittedLaw& l)
{
    return l.law.family == "drag" ? ofDrag(l) : ofPush(l);
}


Foam::string Foam::misfit::describe(const correctionFound& c)
{
    if (c.failure.size())
    {
        return "The free correction could not be fitted: " + c.failure + '.';
    }
    if (c.elements.empty() && !c.explained)
    {
        return
            c.lawThatFails >= 0 ? whyNoLaw(c)
          : string("No push and no factor on the drag of the free correction explains"
                " it either.");
    }
    string words("It acts like ");
    if (c.explained)
    {
        words += describe(c.laws.first());
    }
    else
    {
        forAll(c.elements, i)
        {
            words +=
                (i ? ", and " : "")
              + describe(c.elements[i].element, c.elements[i].value);
        }
    }
    words += whatIsGone(c);
    if (c.ofSurface)
    {
        words +=
            " The solver fails with it: these numbers are of the response surface.";
    }
    return c.named ? words : string(words + ' ' + whyNotNamed(c));
}
