// SPDX-License-Identifier: GPL-3.0-or-later
// What the dictionaries of all families of closures (drag, lift, ...) share.

#include "closure.H"
#include "error.H"
#include "keywords.H"

Foam::scalar Foam::closure::strength(const dictionary& dict)
{
    const scalar s = dict.getOrDefault<scalar>("strength", 1);

    if (!(s >= 0 && s <= 1))
    {
        FatalIOErrorInFunction(dict)
            << "strength is " << s << "; it must lie between 0 (the law is "
            << "off) and 1 (the law as published)."
            << exit(FatalIOError);
    }

    return s;
}


Foam::dictionary Foam::closure::without
(
    const dictionary& dict,
    const wordList& keywords
)
{
    dictionary rest(dict);
    for (const word& keyword : keywords)
    {
        rest.remove(keyword);
    }
    return rest;
}


void Foam::closure::checkKeywords
(
    const dictionary& dict,
    const wordList& settings
)
{
    keywords::check
    (
        dict,
        settings,
        "\nBeside them, where the law is chosen: model strength"
        " (for drag also: base baseSettings shape correction)"
    );
}
