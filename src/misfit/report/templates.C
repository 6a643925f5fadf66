// SPDX-License-Identifier: GPL-3.0-or-later
// Templates of etc/misfit, filled with a record.

#include "templates.H"
#include "numberWords.H"
#include "textFile.H"

#include "error.H"
#include "fileName.H"

#include <kainjow/mustache.hpp>

#include <algorithm>
#include <sstream>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
namespace mustache = kainjow::mustache;

mustache::data mustacheData(const json& from)
{
    if (from.is_object())
    {
        mustache::object all;
        for (const auto& [key, value] : from.items())
        {
            all.emplace(key, mustacheData(value));
            if (value.is_array())
            {
                all.emplace(key + '?', !value.empty());
            }
        }
        return all;
    }
    if (from.is_array())
    {
        mustache::list all;
        std::transform(from.begin(), from.end(), std::back_inserter(all), &mustacheData);
        return all;
    }
    if (from.is_boolean() || from.is_null() || from == "")
    {
        return from == true;
    }
    return
        from.is_string() ? from.get<std::string>()
      : from.is_number_float() ? numberWords(from) : from.dump();
}


//- The template of that file, which has the text; fatal, naming the line, where its
//  syntax has a fault
mustache::mustache checkedTemplate(const word& file, const string& text)
{
    const mustache::mustache parsed(text);
    if (!parsed.is_valid())
    {
        // It ends with how many characters are before the fault
        const std::string fault(parsed.error_message());
        const size_t at = fault.rfind(" at ");
        const size_t before = std::stoul(fault.substr(at + 4));
        FatalErrorInFunction
            << "Line " << 1 + std::count(text.begin(), text.begin() + before, '\n')
            << " of " << fileName("$INTERDEMFOAM_DIR/etc/misfit/" + file).expand()
            << ", which a report is made with: " << fault.substr(0, at)
            << ". Correct it, or restore the file from the sources" << exit(FatalError);
    }
    return parsed;
}


//- Text without line breaks and indentation, which are for its reader alone
std::string onOneLine(const std::string& text)
{
    std::istringstream is(text);
    std::string all;
    for (std::string line; std::getline(is, line);)
    {
        all += line.substr(std::min(line.find_first_not_of(' '), line.size()));
    }
    return all;
}

} // End anonymous namespace


Foam::string Foam::misfit::templateText(const word& file)
{
    const fileName whole(fileName("$INTERDEMFOAM_DIR/etc/misfit/" + file).expand());
    const string text(contentOf(whole));
    if (text.empty())
    {
        FatalErrorInFunction
            << "Cannot read " << whole << ", which a report is made with. Restore it"
            << " from the sources" << exit(FatalError);
    }
    return text;
}


std::string Foam::misfit::fillTemplate(const word& file, const json& from)
{
    return checkedTemplate(file, templateText(file)).render(mustacheData(from));
}


Foam::string Foam::misfit::renderTemplate(const word& part, const json& facts)
{
    static mustache::mustache words
    (
        [text = templateText("words")]()
        {
            checkedTemplate("words", text);
            return onOneLine(text);
        }()
    );
    words.set_custom_escape([](const std::string& text) { return text; });
    return words.render(mustache::object{{part, mustacheData(facts)}});
}
