// SPDX-License-Identifier: GPL-3.0-or-later
// What the dictionaries of all families of closures (drag, lift, ...) share.

#include "closure.H"
#include "error.H"
#include "ListOps.H"
#include "wordList.H"

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


void Foam::closure::checkKeywords
(
    const dictionary& dict,
    std::initializer_list<word> own
)
{
    wordList valid(own);
    valid.append(wordList({"model", "strength", "base", "baseSettings"}));

    for (const word& keyword : dict.toc())
    {
        if (!valid.found(keyword))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword " << keyword << " in " << dict.name()
                << nl << "Valid keywords here: " << flatOutput(valid)
                << exit(FatalIOError);
        }
    }
}


Foam::word Foam::closure::validName
(
    const dictionary& dict,
    const word& keyword,
    const word& family,
    const wordList& valid
)
{
    if (!dict.found(keyword))
    {
        FatalIOErrorInFunction(dict)
            << "The keyword " << keyword << ", which names a " << family
            << " law, is missing in " << dict.name() << nl
            << "Valid names: " << flatOutput(valid)
            << exit(FatalIOError);
    }

    const word name(dict.get<word>(keyword));

    if (!valid.found(name))
    {
        FatalIOErrorInFunction(dict)
            << "There is no " << family << " law named " << name
            << " (keyword " << keyword << " in " << dict.name() << ")" << nl
            << "Valid names: " << flatOutput(valid)
            << exit(FatalIOError);
    }

    return name;
}
