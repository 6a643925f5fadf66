// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that a free correction may follow: its elements as functions of
// dimensionless numbers.

#include "dimensionlessLaws.H"
#include "lawFunctions.H"

#include <cmath>

namespace
{

using namespace Foam;
using namespace Foam::misfit;

//- True if it is nonzero, or, beside a constant, if it varies
bool isInformative(const vec& column, const bool beside)
{
    const scalar size = column.cwiseAbs().maxCoeff();
    const scalar spread = column.maxCoeff() - column.minCoeff();
    return beside ? spread > 1e-6*max(size, VSMALL) : size > 0;
}


//- Functions of dimensionless numbers that the elements of a family may follow
struct groupFunctions
{
    const List<lawFunction>& functions;

    //- A row for each element, a column for each function
    mat values;

    scalarList middle;

    groupFunctions
    (
        const elementFamily family,
        const List<correctionElement>& elements,
        const HashTable<conditions>& water
    )
    :
        functions(functionsOf(family)),
        values(mat::Zero(elements.size(), functions.size())),
        middle(functions.size(), scalar(1))
    {
        if (family == elementFamily::drag)
        {
            ofDrag(elements);
        }
        else
        {
            ofPush(elements, water);
        }
    }


    void ofDrag(const List<correctionElement>& elements)
    {
        forAll(elements, i)
        {
            const correctionElement& e = elements[i];
            if (e.family == elementFamily::drag)
            {
                values(i, 0) = 1;
                values(i, 1) = std::log(e.Reynolds);
                values(i, 2) = std::log(e.voidFraction);
            }
        }

        // From their middle, so that the likelihood of one does not depend on another
        const scalar n = max(values.col(0).sum(), 1.0);
        for (label f = 1; f < values.cols(); ++f)
        {
            const scalar mean = values.col(f).sum()/n;
            values.col(f) -= mean*values.col(0);
            middle[f] = std::exp(mean);
        }
    }


    void ofPush
    (
        const List<correctionElement>& elements,
        const HashTable<conditions>& water
    )
    {
        forAll(elements, i)
        {
            const correctionElement& e = elements[i];
            if (e.family != elementFamily::push || !water.found(e.name))
            {
                continue;
            }
            const conditions& c = water[e.name];
            if (c.depth > 1e-6 && c.gravity > 0)
            {
                // Coefficients are shares of the water's weight
                const scalar weight = c.density*c.gravity;
                const scalar sign = c.velocity < 0 ? -1 : c.velocity > 0 ? 1 : 0;
                const scalar depths = c.gravity*c.depth;
                values(i, 0) = weight*sign;
                values(i, 1) = weight*c.velocity*mag(c.velocity)/depths;
                values(i, 2) = weight*c.viscosity*c.velocity/(depths*c.depth);
                values(i, 3) = weight*sign*max(1 - c.voidFraction, 0.0);
            }
        }
    }


    //- Functions that distinguish the elements of the family
    labelList informative(const bool drag) const
    {
        // Rows of its family only: elsewhere all functions are zero
        std::vector<int> own;
        for (label i = 0; i < values.rows(); ++i)
        {
            if (values.row(i).cwiseAbs().maxCoeff() > 0)
            {
                own.push_back(i);
            }
        }
        labelList list;
        for (label f = drag; f < functions.size() && own.size(); ++f)
        {
            if (isInformative(values.col(f)(own), drag))
            {
                list.append(f);
            }
        }
        return list;
    }
};

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


Foam::misfit::mat Foam::misfit::combinationOf
(
    const dimensionlessLaw& law,
    const List<correctionElement>& elements,
    const HashTable<conditions>& water
)
{
    return groupFunctions(law.family, elements, water).values(Eigen::all, law.functions);
}


Foam::List<Foam::misfit::dimensionlessLaw> Foam::misfit::lawsOf
(
    const elementFamily family,
    const List<correctionElement>& elements,
    const HashTable<conditions>& water
)
{
    const groupFunctions all(family, elements, water);
    if (all.values.isZero(0))
    {
        return List<dimensionlessLaw>();
    }

    // A factor on the drag always has its constant
    const bool drag = family == elementFamily::drag;
    const labelList informative(all.informative(drag));
    List<labelList> sets;
    if (drag)
    {
        sets.append(labelList({0}));
    }
    forAll(informative, i)
    {
        labelList one(drag ? labelList({0}) : labelList());
        one.append(informative[i]);
        sets.append(one);
        for (label j = i + 1; j < informative.size(); ++j)
        {
            labelList two(one);
            two.append(informative[j]);
            sets.append(two);
        }
    }

    List<dimensionlessLaw> laws;
    for (const labelList& functions : sets)
    {
        dimensionlessLaw law;
        law.family = family;
        law.functions = functions;
        law.combination = all.values(Eigen::all, functions);
        for (const label f : functions)
        {
            const word& group = all.functions[f].group;
            if (group.size())
            {
                law.groups.append(group);
            }
            law.middle.append(all.middle[f]);
        }
        laws.append(law);
    }
    return laws;
}
