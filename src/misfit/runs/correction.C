// SPDX-License-Identifier: GPL-3.0-or-later
// A free correction of the simulation, for what no candidate explains: pushes on
// the water by station and time, and a factor on the drag.

#include "correction.H"
#include "keywords.H"
#include "numberTable.H"

#include "OSspecific.H"
#include "StringStream.H"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

const Foam::Enum<Foam::misfit::elementFamily> Foam::misfit::familyNames
({
    {elementFamily::push, "push"},
    {elementFamily::drag, "drag"}
});


namespace
{

using namespace Foam;

//- Nodes that must rise
scalarList nodes(const dictionary& dict, const word& key)
{
    const scalarList list(dict.get<scalarList>(key));
    const auto fall = std::adjacent_find
    (
        list.cbegin(), list.cend(), std::greater_equal<scalar>()
    );
    if (list.empty() || fall != list.cend())
    {
        FatalIOErrorInFunction(dict)
            << key << ' ' << list << " of the correction must rise, and be one"
            << " or more" << exit(FatalIOError);
    }
    return list;
}


//- What the size of an element is
const char* const likely = ": it is what is likely";


//- A number that must be above zero; meaning: what to give, for the error
scalar aboveZero
(
    const dictionary& dict,
    const word& key,
    const char* meaning = ""
)
{
    const scalar value = dict.get<scalar>(key);
    if (value <= 0)
    {
        FatalIOErrorInFunction(dict)
            << key << ' ' << value << " of the correction must be above zero"
            << meaning << exit(FatalIOError);
    }
    return value;
}


//- Distances of a node to its neighbours; at an end that of the other side. One
//  alone needs it from the dictionary
Pair<scalar> reachOf
(
    const dictionary& dict,
    const word& key,
    const scalarList& list,
    const label i
)
{
    if (dict.found(key) || list.size() == 1)
    {
        const scalar distance = aboveZero(dict, key);
        return Pair<scalar>(distance, distance);
    }
    const label last = list.size() - 1;
    const scalar before = i > 0 ? list[i] - list[i - 1] : list[1] - list[0];
    const scalar after =
        i < last ? list[i + 1] - list[i] : list[last] - list[last - 1];
    return Pair<scalar>(before, after);
}


//- Numbers in brackets, after a blank
string inBrackets(const scalarList& numbers)
{
    OStringStream os;
    os.precision(10);
    for (const scalar number : numbers)
    {
        os << ' ' << number;
    }
    return " (" + os.str() + " )";
}


word numbered(const word& family, const label i, const label j)
{
    return family + Foam::name(i + 1) + '_' + Foam::name(j + 1);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::misfit::correction::readPush(const dictionary& dict)
{
    keywords::check
    (
        dict,
        {
            "direction", "stations", "times", "reach", "lasting", "size",
            "phase", "up"
        }
    );
    const scalarList stations(nodes(dict, "stations"));
    const scalarList times(nodes(dict, "times"));
    for (const word key : {"phase", "up"})
    {
        if (dict.found(key))
        {
            ofPush_.add(dict.lookupEntry(key, keyType::LITERAL));
        }
    }
    correctionElement e;
    e.family = elementFamily::push;
    e.size = aboveZero(dict, "size", likely);
    e.direction = keywords::unitVector(dict, "direction", e.direction);
    forAll(stations, i)
    {
        forAll(times, j)
        {
            e.name = numbered("push", i, j);
            e.place = stations[i];
            e.reach = reachOf(dict, "reach", stations, i);
            e.time = times[j];
            e.lasting = reachOf(dict, "lasting", times, j);
            elements_.append(e);
        }
    }
}


void Foam::misfit::correction::readDrag(const dictionary& dict)
{
    keywords::check(dict, {"voidFraction", "Reynolds", "size"});
    voidFractions_ = nodes(dict, "voidFraction");
    Reynolds_ = nodes(dict, "Reynolds");
    if (voidFractions_.first() <= 0 || Reynolds_.first() <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "voidFraction " << voidFractions_ << " and Reynolds "
            << Reynolds_ << " of the drag's correction must be above zero"
            << exit(FatalIOError);
    }
    correctionElement e;
    e.family = elementFamily::drag;
    e.size = aboveZero(dict, "size", likely);
    forAll(voidFractions_, i)
    {
        forAll(Reynolds_, j)
        {
            e.name = numbered("drag", i, j);
            e.voidFraction = voidFractions_[i];
            e.Reynolds = Reynolds_[j];
            elements_.append(e);
        }
    }
}


Foam::string Foam::misfit::correction::push
(
    const correctionElement& e,
    const scalar force
) const
{
    OStringStream os;
    os.precision(10);
    os << "{ type localisedMomentumSource; libs (\"libfluidSources.so\");"
        << " direction " << e.direction << "; force " << force << "; place " << e.place
        << "; reach " << e.reach << "; time " << e.time << "; lasting "
        << e.lasting << "; ";
    ofPush_.write(os, false);
    os << '}';
    return os.str();
}


Foam::string Foam::misfit::correction::drag
(
    const HashTable<scalar>& strengths
) const
{
    string rows;
    scalarList row(Reynolds_.size());
    forAll(voidFractions_, i)
    {
        forAll(row, j)
        {
            row[j] = strengths.lookup(numbered("drag", i, j), 0);
        }
        rows += inBrackets(row);
    }
    return
        "{ voidFraction" + inBrackets(voidFractions_) + "; Reynolds"
      + inBrackets(Reynolds_) + "; logarithm (" + rows + " ); }";
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::misfit::correction::correction(const dictionary& misfitDict)
{
    const dictionary dict
    (
        keywords::sub
        (
            misfitDict, "correction", wordList({"push", "drag", "most"})
        )
    );
    if (dict.found("push"))
    {
        readPush(keywords::sub(dict, "push"));
    }
    if (dict.found("drag"))
    {
        readDrag(keywords::sub(dict, "drag"));
    }
}


// * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * * //

Foam::List<Foam::misfit::caseChange> Foam::misfit::correction::changes
(
    const HashTable<scalar>& strengths,
    const bool noting,
    const fileName& templateCase
) const
{
    const fileName options
    (
        isFile(templateCase/"system/fvOptions")
     && !isFile(templateCase/"constant/fvOptions")
      ? "system/fvOptions" : "constant/fvOptions"
    );

    List<caseChange> all;
    bool dragChanges = false;
    for (const correctionElement& e : elements_)
    {
        const scalar value = strengths.lookup(e.name, 0);
        if (e.family == elementFamily::drag)
        {
            dragChanges = dragChanges || value != 0;
        }
        else if (value != 0 || noting)
        {
            all.append(caseChange(options, e.name, push(e, value)));
        }
    }
    if (dragChanges)
    {
        all.append
        (
            caseChange
            (
                "constant/granularProperties",
                "interphaseForces/drag/correction",
                drag(strengths)
            )
        );
    }
    return all;
}


Foam::HashTable<Foam::misfit::conditions>
Foam::misfit::correction::waterIn(const fileName& caseFolder) const
{
    HashTable<conditions> all;
    for (const correctionElement& e : elements_)
    {
        if (!isDir(caseFolder/"postProcessing"/e.name))
        {
            continue;
        }

        // Time share U depth voidFraction rho nu g: means over the steps, by their
        // share
        const numberTable table
        (
            writtenTable(caseFolder, e.name, "localisedMomentumSource.dat")
        );
        const scalarList time(table.column(0));
        const scalarList share(table.column(1));
        conditions mean;
        const List<scalar*> means
        ({
            &mean.velocity, &mean.depth, &mean.voidFraction, &mean.density,
            &mean.viscosity, &mean.gravity
        });
        scalarList weight(time.size(), Zero);
        for (label row = 1; row < time.size(); ++row)
        {
            weight[row] = share[row]*(time[row] - time[row - 1]);
        }
        const scalar sum = std::accumulate(weight.cbegin(), weight.cend(), scalar(0));
        forAll(means, i)
        {
            const scalarList values(table.column(2 + i));
            *means[i] =
                std::inner_product
                (
                    weight.cbegin(), weight.cend(), values.cbegin(), scalar(0)
                )/max(sum, VSMALL);
        }
        all.insert(e.name, sum > 0 ? mean : conditions());
    }
    return all;
}
