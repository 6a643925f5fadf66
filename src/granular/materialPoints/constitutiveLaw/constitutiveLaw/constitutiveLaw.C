// SPDX-License-Identifier: GPL-3.0-or-later
// Base of the laws between strain and stress of material points, chosen by
// name.

#include "constitutiveLaw.H"

#include "keywords.H"

namespace Foam
{
    defineTypeNameAndDebug(constitutiveLaw, 0);
    defineRunTimeSelectionTable(constitutiveLaw, dictionary);
}


const Foam::dictionary& Foam::constitutiveLaw::checked
(
    const dictionary& dict,
    const wordList& lawKeys
)
{
    wordList all
    (
        {
            "law", "density", "E", "nu", "solidDensity", "grainDiameter",
            "poreDiameter"
        }
    );
    all.append(lawKeys);
    keywords::check(dict, all);

    return dict;
}


Foam::scalar Foam::constitutiveLaw::positive
(
    const dictionary& dict,
    const word& keyword
)
{
    const scalar value = dict.get<scalar>(keyword);

    if (!(value > 0))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << value << "; it must be above zero."
            << exit(FatalIOError);
    }

    return value;
}


Foam::constitutiveLaw::constitutiveLaw(const dictionary& dict)
:
    density_(positive(dict, "density")),
    E_(positive(dict, "E")),
    nu_(dict.get<scalar>("nu"))
{
    if (!(nu_ >= 0 && nu_ < 0.5))
    {
        FatalIOErrorInFunction(dict)
            << "nu is " << nu_ << "; Poisson's ratio must lie from 0 up to, but"
            << " not at, 0.5." << exit(FatalIOError);
    }
}


Foam::autoPtr<Foam::constitutiveLaw> Foam::constitutiveLaw::New
(
    const dictionary& dict
)
{
    const auto& table = *dictionaryConstructorTablePtr_;
    const word name
    (
        keywords::choice(dict, "law", "constitutive law", table.sortedToc())
    );

    return table.cfind(name).val()(dict);
}
