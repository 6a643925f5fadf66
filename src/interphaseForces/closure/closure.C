// SPDX-License-Identifier: GPL-3.0-or-later
// What the dictionaries of all families of closures (drag, lift, ...) share.

#include "closure.H"
#include "error.H"

namespace
{

//- Words in one line, for a person to read
std::string listed(const Foam::wordList& words)
{
    std::string line;
    for (const Foam::word& word : words)
    {
        line += ' ' + word;
    }
    return words.empty() ? " none" : line;
}

} // End anonymous namespace


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
    const wordList& own
)
{
    for (const word& keyword : dict.toc())
    {
        if (!own.found(keyword))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword " << keyword << " in " << dict.name()
                << nl << "Settings of this law:" << listed(own).c_str() << nl
                << "Beside them, where the law is chosen: model strength"
                << " (for drag also: base baseSettings)"
                << exit(FatalIOError);
        }
    }
}


Foam::word Foam::closure::validName
(
    const dictionary& dict,
    const word& keyword,
    const string& what,
    const wordList& valid
)
{
    if (!dict.found(keyword))
    {
        FatalIOErrorInFunction(dict)
            << "The keyword " << keyword << ", which names a " << what.c_str()
            << ", is missing in " << dict.name() << nl
            << "Valid names:" << listed(valid).c_str()
            << exit(FatalIOError);
    }

    const word name(dict.get<word>(keyword));

    if (!valid.found(name))
    {
        FatalIOErrorInFunction(dict)
            << "There is no " << what.c_str() << " named " << name
            << " (keyword " << keyword << " in " << dict.name() << ')' << nl
            << "Valid names:" << listed(valid).c_str()
            << exit(FatalIOError);
    }

    return name;
}
