// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as they stand in a sentence or a table: never with the exponent of a large one.

#include "numberWords.H"
#include "shortNumber.H"

#include <cmath>

namespace
{

using namespace Foam;

//- In place of what is not a number
constexpr const char* notKnown = "not known";


//- All digits of a whole number
std::string wholeNumber(const scalar value)
{
    std::ostringstream os;
    os << std::fixed << std::setprecision(0) << value;
    return os.str();
}


//- A number with so many significant digits, of one beyond a limit only that it is
string within(const scalar limit, const scalar value, const int digits)
{
    if (std::isnan(value))
    {
        return notKnown;
    }
    if (mag(value) > limit)
    {
        return (value > 0 ? "more than " : "less than -") + wholeNumber(limit);
    }
    const scalar shorter = rounded(value, digits);
    return
        mag(shorter) >= std::pow(10, digits)
      ? wholeNumber(shorter) : shortNumber(value, digits);
}

} // End anonymous namespace


Foam::string Foam::misfit::numberWords(const scalar value, const int digits)
{
    return within(1e9, value, digits);
}


Foam::string Foam::misfit::ratioWords(const scalar value, const int digits)
{
    return within(1e5, value, digits);
}


Foam::string Foam::misfit::percentWords(const scalar share)
{
    // To compare what is not a number would stop the program
    if (std::isnan(share))
    {
        return notKnown;
    }

    // Whole only where it is: a name of which 0.3 % is open is not certain
    if (share > 0 && share < 0.005)
    {
        return "less than 1 %";
    }
    if (share >= 0.995 && share < 1)
    {
        return "more than 99 %";
    }
    return within(1000, std::round(100*share) + 0.0, 4) + " %";
}
