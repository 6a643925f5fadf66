// SPDX-License-Identifier: GPL-3.0-or-later
// What is read from the text of a LIGGGHTS script.

#include "liggghtsScript.H"

#include "error.H"

#include <fstream>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

std::string Foam::liggghtsScript::text(const fileName& script)
{
    std::ifstream is(script);
    const std::string all
    (
        (std::istreambuf_iterator<char>(is)),
        std::istreambuf_iterator<char>()
    );

    // A line ending in & goes on in the next
    return std::regex_replace
    (
        std::regex_replace(all, std::regex("#[^\n]*"), ""),
        std::regex("&[ \t]*\n"),
        " "
    );
}


Foam::DynamicList<std::string> Foam::liggghtsScript::commands
(
    const fileName& script,
    const std::string& command
)
{
    DynamicList<std::string> result;
    std::istringstream lines(text(script));

    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream words(line);
        std::string first;

        if (words >> first && first == command)
        {
            result.append(line);
        }
    }

    return result;
}


Foam::string Foam::liggghtsScript::contactModel(const fileName& script)
{
    const std::string all(text(script));
    const std::regex pairStyle("(^|\n)[ \t]*pair_style[ \t]+gran[ \t]+([^\n]*)");
    std::smatch match;

    if (!std::regex_search(all, match, pairStyle))
    {
        FatalErrorInFunction
            << "No line 'pair_style gran ...' in " << script << nl
            << "    The walls take the contact model from it. Give one, or"
            << " LIGGGHTS/walls/contactModel in constant/granularProperties."
            << exit(FatalError);
    }

    return match.str(2);
}


Foam::liggghtsScript::contactModelParts
Foam::liggghtsScript::parts(const string& contactModel)
{
    const std::set<std::string> families
    {
        "model", "tangential", "cohesion", "rolling_friction", "surface"
    };
    contactModelParts result;
    std::istringstream words(contactModel);
    std::string word;

    while (words >> word && (families.count(word) || word[0] == '$'))
    {
        result.models += " " + word;
        if (families.count(word) && words >> word)
        {
            result.models += " " + word;
        }
    }
    for (; words; words >> word)
    {
        result.options += " " + word;
    }

    return result;
}


Foam::DynamicList<Foam::liggghtsScript::wall>
Foam::liggghtsScript::walls(const fileName& script)
{
    const std::string all(text(script));
    const std::regex fix
    (
        "(?:^|\n)[ \t]*fix[ \t]+([^ \t]+)[ \t]+[^ \t]+[ \t]+wall/gran[ \t]"
        "([^\n]*)"
    );
    const std::regex plane("([xyz])plane[ \t]+([-+0-9.eE]+)");
    const std::regex surfaces("[ \t]meshes[ \t]+([^\n]*)");

    DynamicList<wall> result;
    for (std::sregex_iterator at(all.begin(), all.end(), fix), end; at != end; ++at)
    {
        wall next{word(at->str(1)), -1, 0, wordList()};
        const std::string arguments(at->str(2));
        std::smatch part;

        if (std::regex_search(arguments, part, plane))
        {
            next.normal = part.str(1)[0] - 'x';
            next.at = std::strtod(part.str(2).c_str(), nullptr);
        }
        else if (std::regex_search(arguments, part, surfaces))
        {
            std::istringstream names(part.str(1));
            for (std::string name; names >> name;)
            {
                next.surfaces.append(word(name));
            }
        }

        result.append(next);
    }

    return result;
}
