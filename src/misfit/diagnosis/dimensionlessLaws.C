// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that a free correction may follow: its elements as functions of
// dimensionless numbers.

#include "dimensionlessLaws.H"
#include "StringStream.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

const wordList dragGroups({"", "Re_p", "voidFraction"});

const wordList pushGroups({"", "Fr", "Re", "voidFraction"});

//- What stands after a coefficient, in words
const stringList pushWords
({
    "times the weight of the water, whatever its velocity",
    "Fr^2 times the weight of the water",
    "Fr^2/Re times the weight of the water",
    "times the solid fraction and the weight of the water"
});


//- True if it is not the same, or nothing, for all
bool tells(const vec& column, const bool beside)
{
    const scalar size = column.cwiseAbs().maxCoeff();
    const scalar spread = column.maxCoeff() - column.minCoeff();
    return beside ? spread > 1e-6*max(size, VSMALL) : size > 0;
}


string withDeviation(const scalar value, const scalar deviation)
{
    OStringStream os;
    os.precision(3);
    os << value << " +- " << 2*deviation;
    return os.str();
}

} // End anonymous namespace


bool Foam::misfit::dimensionlessLaw::contains
(
    const dimensionlessLaw& other
) const
{
    if (other.family != family)
    {
        return false;
    }
    for (const label f : other.functions)
    {
        if (!functions.found(f))
        {
            return false;
        }
    }
    return true;
}


Foam::string Foam::misfit::dimensionlessLaw::told
(
    const vec& coefficients,
    const vec& deviations
) const
{
    string words(family == "drag" ? "the drag times " : "a force on the water of ");
    const bool against =
        family == "push" && functions.size() == 1 && coefficients[0] < 0;
    forAll(functions, i)
    {
        const scalar c = (against ? -1 : 1)*coefficients[i];
        const scalar d = deviations[i];
        words += i ? family == "drag" ? " " : " plus " : "";
        if (family == "push")
        {
            words += withDeviation(c, d) + ' ' + pushWords[functions[i]];
        }
        else if (functions[i] == 0)
        {
            words += withDeviation(std::exp(c), std::exp(c)*d);
        }
        else
        {
            OStringStream os;
            os.precision(3);
            os << '(' << dragGroups[functions[i]] << '/' << middle[i] << ")^("
                << withDeviation(c, d).c_str() << ')';
            words += os.str();
        }
    }
    return
        family == "drag" ? words
      : string(words + (against ? ", against the flow" : ", along the flow"));
}


void Foam::misfit::groupFunctions::ofDrag
(
    const List<correctionElement>& elements
)
{
    forAll(elements, i)
    {
        const correctionElement& e = elements[i];
        if (e.family == "drag")
        {
            values_(i, 0) = 1;
            values_(i, 1) = std::log(e.Reynolds);
            values_(i, 2) = std::log(e.voidFraction);
        }
    }

    // From their middle, so that what is likely of one does not hang on another
    const scalar n = max(values_.col(0).sum(), 1.0);
    for (label f = 1; f < values_.cols(); ++f)
    {
        const scalar mean = values_.col(f).sum()/n;
        values_.col(f) -= mean*values_.col(0);
        middle_[f] = std::exp(mean);
    }
}


void Foam::misfit::groupFunctions::ofPush
(
    const List<correctionElement>& elements,
    const HashTable<conditions>& met
)
{
    forAll(elements, i)
    {
        const correctionElement& e = elements[i];
        if (e.family == "push" && met.found(e.name))
        {
            const conditions& c = met[e.name];
            const scalar h = max(c.depth, 1e-6);
            const scalar sign = c.velocity < 0 ? -1 : c.velocity > 0 ? 1 : 0;
            if (c.depth > 1e-6 && c.gravity > 0)
            {
                // Coefficients are shares of the water's weight
                const scalar weight = c.density*c.gravity;
                const scalar Fr2 = c.velocity*mag(c.velocity)/(c.gravity*h);
                values_(i, 0) = weight*sign;
                values_(i, 1) = weight*Fr2;
                values_(i, 2) =
                    weight*c.viscosity*c.velocity/(c.gravity*h*h);
                values_(i, 3) = weight*sign*max(1 - c.voidFraction, 0.0);
            }
        }
    }
}


Foam::misfit::groupFunctions::groupFunctions
(
    const word& family,
    const List<correctionElement>& elements,
    const HashTable<conditions>& met
)
:
    family_(family),
    groups_(family == "drag" ? dragGroups : pushGroups),
    values_(mat::Zero(elements.size(), groups_.size())),
    middle_(groups_.size(), scalar(1))
{
    if (family == "drag")
    {
        ofDrag(elements);
    }
    else
    {
        ofPush(elements, met);
    }
}


Foam::misfit::mat Foam::misfit::groupFunctions::combination
(
    const dimensionlessLaw& law
) const
{
    mat m(values_.rows(), law.functions.size());
    forAll(law.functions, i)
    {
        m.col(i) = values_.col(law.functions[i]);
    }
    return m;
}


Foam::List<Foam::misfit::dimensionlessLaw>
Foam::misfit::groupFunctions::laws() const
{
    // Rows of its family only: elsewhere all functions are zero
    List<label> own;
    for (label i = 0; i < values_.rows(); ++i)
    {
        if (values_.row(i).cwiseAbs().maxCoeff() > 0)
        {
            own.append(i);
        }
    }
    if (own.empty())
    {
        return List<dimensionlessLaw>();
    }

    const bool drag = family_ == "drag";
    labelList telling;
    for (label f = drag ? 1 : 0; f < groups_.size(); ++f)
    {
        if (tells(rows(values_.col(f), own), drag))
        {
            telling.append(f);
        }
    }

    List<labelList> sets;
    if (drag)
    {
        sets.append(labelList({0}));
    }
    forAll(telling, i)
    {
        labelList one(drag ? labelList({0}) : labelList());
        one.append(telling[i]);
        sets.append(one);
        for (label j = i + 1; j < telling.size(); ++j)
        {
            labelList two(one);
            two.append(telling[j]);
            sets.append(two);
        }
    }

    List<dimensionlessLaw> all;
    for (const labelList& functions : sets)
    {
        dimensionlessLaw law;
        law.family = family_;
        law.functions = functions;
        for (const label f : functions)
        {
            if (!groups_[f].empty())
            {
                law.groups.append(groups_[f]);
            }
            law.middle.append(middle_[f]);
        }
        law.combination = combination(law);
        all.append(law);
    }
    return all;
}
