// SPDX-License-Identifier: GPL-3.0-or-later
// The units that a recording may be in, and the quantities they measure.

#include "units.H"
#include "dimensionSets.H"
#include "HashTable.H"

namespace Foam::misfit
{

static const dimensionSet dimStrainRate(dimless/dimTime);

static const HashTable<unit>& units()
{
    static const HashTable<unit> table
    ({
        {"s", {dimTime, 1}},
        {"ms", {dimTime, 1e-3}},
        {"min", {dimTime, 60}},
        {"h", {dimTime, 3600}},
        {"m", {dimLength, 1}},
        {"cm", {dimLength, 1e-2}},
        {"mm", {dimLength, 1e-3}},
        {"um", {dimLength, 1e-6}},
        {"Pa", {dimPressure, 1}},
        {"hPa", {dimPressure, 100}},
        {"kPa", {dimPressure, 1e3}},
        {"MPa", {dimPressure, 1e6}},
        {"mbar", {dimPressure, 100}},
        {"bar", {dimPressure, 1e5}},
        {"mH2O", {dimPressure, 9806.65}},
        {"cmH2O", {dimPressure, 98.0665}},
        {"psi", {dimPressure, 6894.757}},
        {"m/s", {dimVelocity, 1}},
        {"m_per_s", {dimVelocity, 1}},
        {"cm/s", {dimVelocity, 1e-2}},
        {"mm/s", {dimVelocity, 1e-3}},
        {"N", {dimForce, 1}},
        {"kN", {dimForce, 1e3}},
        {"kg", {dimMass, 1}},
        {"g", {dimMass, 1e-3}},
        {"m3/s", {dimVolume/dimTime, 1}},
        {"l/s", {dimVolume/dimTime, 1e-3}},
        {"1/s", {dimStrainRate, 1}},
        {"-", {dimless, 1}},
        {"1", {dimless, 1}},
        {"%", {dimless, 1e-2}}
    });
    return table;
}


static const HashTable<dimensionSet>& quantities()
{
    static const HashTable<dimensionSet> table
    ({
        {"time", dimTime},
        {"length", dimLength},
        {"pressure", dimPressure},
        {"velocity", dimVelocity},
        {"force", dimForce},
        {"mass", dimMass},
        {"flowRate", dimVolume/dimTime},
        {"rate", dimStrainRate},
        {"dimensionless", dimless}
    });
    return table;
}

} // End namespace Foam::misfit


const Foam::misfit::unit* Foam::misfit::findUnit(const word& name)
{
    return units().found(name) ? &units()[name] : nullptr;
}


const Foam::dimensionSet* Foam::misfit::findQuantity(const word& name)
{
    return quantities().found(name) ? &quantities()[name] : nullptr;
}


Foam::wordList Foam::misfit::quantityNames()
{
    return quantities().sortedToc();
}


Foam::wordList Foam::misfit::unitsOf(const dimensionSet& dimensions)
{
    DynamicList<word> names;
    for (const word& name : units().sortedToc())
    {
        if (units()[name].dimensions == dimensions)
        {
            names.append(name);
        }
    }
    return wordList(std::move(names));
}


Foam::word Foam::misfit::siUnit(const word& quantity)
{
    const dimensionSet* dimensions = findQuantity(quantity);
    if (!dimensions || dimensions->dimensionless())
    {
        return word();
    }
    word shortest;
    for (const word& name : unitsOf(*dimensions))
    {
        const bool shorter = shortest.empty() || name.size() < shortest.size();
        if (units()[name].size == 1 && shorter)
        {
            shortest = name;
        }
    }
    return shortest;
}


Foam::word Foam::misfit::unitInName(const string& column)
{
    const auto open = column.find('[');
    if (open != string::npos)
    {
        const auto close = column.find(']', open);
        const word name
        (
            close == string::npos
          ? std::string()
          : column.substr(open + 1, close - open - 1),
            false
        );
        return findUnit(name) ? name : word();
    }

    for
    (
        auto at = column.find('_');
        at != string::npos;
        at = column.find('_', at + 1)
    )
    {
        const word name(column.substr(at + 1), false);
        if (findUnit(name))
        {
            return name;
        }
    }
    return word();
}
