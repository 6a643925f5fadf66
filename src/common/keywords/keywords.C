// SPDX-License-Identifier: GPL-3.0-or-later
// What a dictionary may hold: the one check of all keywords and choices.

#include "keywords.H"

#include "error.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

namespace
{

using namespace Foam;

//- Fatal if a name or pattern matches none of the valid names
template<class Pattern>
void mustMatch
(
    const dictionary& dict,
    const Pattern& pattern,
    const word& keyword,
    const wordList& valid
)
{
    for (const word& name : valid)
    {
        if (pattern.match(name))
        {
            return;
        }
    }

    FatalIOErrorInFunction(dict)
        << pattern << " (keyword " << keyword << " in " << dict.name()
        << ") is none of the names here" << nl
        << "Valid names:" << keywords::listed(valid).c_str()
        << exit(FatalIOError);
}

} // End anonymous namespace


Foam::string Foam::keywords::listed(const wordList& words)
{
    string line;
    for (const word& w : words)
    {
        line += ' ' + w;
    }

    return words.empty() ? string(" none") : line;
}


void Foam::keywords::check
(
    const dictionary& dict,
    const wordList& valid,
    const string& hint
)
{
    for (const word& keyword : dict.toc())
    {
        if (!valid.found(keyword))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown keyword " << keyword << " in " << dict.name()
                << nl << "Valid keywords:" << listed(valid).c_str()
                << hint.c_str() << exit(FatalIOError);
        }
    }
}


void Foam::keywords::stopRenamed
(
    const dictionary& dict,
    const word& old,
    const word& present
)
{
    FatalIOErrorInFunction(dict)
        << old << " in " << dict.name() << " is called " << present << " now"
        << nl << "    Write " << present << " in its place."
        << exit(FatalIOError);
}


void Foam::keywords::checkRenamed
(
    const dictionary& dict,
    const HashTable<word>& present
)
{
    for (const word& old : present.sortedToc())
    {
        if (dict.found(old))
        {
            stopRenamed(dict, old, present[old]);
        }
    }
}


void Foam::keywords::checkPatterns
(
    const dictionary& dict,
    const wordList& valid
)
{
    for (const entry& e : dict)
    {
        mustMatch(dict, e.keyword(), e.keyword(), valid);
    }
}


Foam::dictionary Foam::keywords::sub
(
    const dictionary& dict,
    const word& keyword
)
{
    if (dict.found(keyword) && !dict.isDict(keyword))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " in " << dict.name() << " is no dictionary" << nl
            << "    Its settings stand in braces: " << keyword << " { ... }"
            << exit(FatalIOError);
    }

    return dict.subOrEmptyDict(keyword);
}


Foam::dictionary Foam::keywords::sub
(
    const dictionary& dict,
    const word& keyword,
    const wordList& valid
)
{
    const dictionary settings(sub(dict, keyword));
    check(settings, valid);

    return settings;
}


Foam::word Foam::keywords::choice
(
    const dictionary& dict,
    const word& keyword,
    const string& what,
    const wordList& valid,
    const word& byDefault,
    const HashTable<word>& renamed
)
{
    if (!dict.found(keyword) && byDefault.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The keyword " << keyword << ", which names a " << what.c_str()
            << ", is missing in " << dict.name() << nl
            << "Valid names:" << listed(valid).c_str()
            << exit(FatalIOError);
    }

    const word name(dict.getOrDefault<word>(keyword, byDefault));

    if (renamed.found(name))
    {
        stopRenamed(dict, name, renamed[name]);
    }

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


Foam::vector Foam::keywords::unitVector
(
    const dictionary& dict,
    const word& keyword,
    const vector& byDefault
)
{
    const vector v
    (
        byDefault == vector::zero
      ? dict.get<vector>(keyword)
      : dict.getOrDefault<vector>(keyword, byDefault)
    );

    if (mag(v) < SMALL)
    {
        FatalIOErrorInFunction(dict)
            << keyword << " in " << dict.name() << " is " << v
            << ": it has no direction." << nl
            << "    Give a vector other than zero, as (1 0 0)"
            << exit(FatalIOError);
    }

    return v/mag(v);
}


Foam::scalar Foam::keywords::frictionAngle
(
    const dictionary& dict,
    const word& keyword
)
{
    const scalar angle = dict.get<scalar>(keyword);

    if (!(angle >= 0 && angle < 90))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << angle << " degrees; it must lie from 0 up"
            << " to, but not at, 90." << exit(FatalIOError);
    }

    // Each angle below 90 degrees is, in radians, below pi/2, and hardly a
    // material has so few degrees
    if (angle > 0 && angle < constant::mathematical::piByTwo)
    {
        IOWarningInFunction(dict)
            << keyword << " is " << angle << " degrees: nearly no friction. If it"
            << " was meant in radians," << nl << "    write "
            << radToDeg(angle) << endl;
    }

    return degToRad(angle);
}


Foam::wordRes Foam::keywords::patterns
(
    const dictionary& dict,
    const word& keyword,
    const wordList& valid,
    const wordRes& byDefault
)
{
    if (!dict.found(keyword))
    {
        return byDefault;
    }

    const wordRes result(dict.get<wordRes>(keyword));

    for (const wordRe& pattern : result)
    {
        mustMatch(dict, pattern, keyword, valid);
    }

    return result;
}
