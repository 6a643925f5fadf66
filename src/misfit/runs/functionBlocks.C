// SPDX-License-Identifier: GPL-3.0-or-later
// What a dictionary computes in braces, kept as it stands while the rest is changed.

#include "functionBlocks.H"

#include <cctype>

namespace
{

using namespace Foam;

bool startsWith(const string& text, const size_t at, const char* words)
{
    return text.compare(at, std::char_traits<char>::length(words), words) == 0;
}


//- The place after the next such words; the end if there are none
size_t after(const string& text, const size_t from, const char* words)
{
    const size_t at = text.find(words, from);
    return
        at == string::npos
      ? text.size() : at + std::char_traits<char>::length(words);
}


//- The place after the quotation that begins there
size_t afterQuoted(const string& text, size_t at)
{
    for (++at; at < text.size() && text[at] != '"'; ++at)
    {
        at += text[at] == '\\';
    }
    return std::min(at + 1, text.size());
}


//- The place after a comment, a quotation or verbatim text that begins there; the same
//  place where none does
size_t afterClosed(const string& text, const size_t at)
{
    return
        startsWith(text, at, "//") ? text.find('\n', at) == string::npos
      ? text.size() : text.find('\n', at)
      : startsWith(text, at, "/*") ? after(text, at + 2, "*/")
      : startsWith(text, at, "#{") ? after(text, at + 2, "#}")
      : text[at] == '"' ? afterQuoted(text, at) : at;
}


//- The place after the brace that closes the one there
size_t afterBraces(const string& text, size_t at)
{
    label depth = 0;
    while (at < text.size())
    {
        const size_t closed = afterClosed(text, at);
        if (closed > at)
        {
            at = closed;
            continue;
        }
        depth += (text[at] == '{') - (text[at] == '}');
        ++at;
        if (!depth)
        {
            break;
        }
    }
    return at;
}


//- The place after a function with its braces that begins there; the same place where
//  none does
size_t afterFunction(const string& text, const size_t at)
{
    if (startsWith(text, at, "${{"))
    {
        return after(text, at, "}}");
    }
    size_t to = at + 1;
    if (text[at] != '#' || to >= text.size() || !std::isalpha(text[to]))
    {
        return at;
    }
    while (to < text.size() && std::isalnum(text[to]))
    {
        ++to;
    }
    while (to < text.size() && std::isspace(text[to]))
    {
        ++to;
    }
    return
        startsWith(text, to, "#{") ? after(text, to + 2, "#}")
      : startsWith(text, to, "{") ? afterBraces(text, to) : at;
}


//- The string that stands for one of them
string placeholder(const label i)
{
    return "\"misfitFunction" + Foam::name(i) + "\"";
}

} // End anonymous namespace


Foam::string Foam::misfit::functionBlocks::add(const string& more)
{
    string text;
    size_t at = 0;
    while (at < more.size())
    {
        const size_t function = afterFunction(more, at);
        const size_t to = max(function, max(afterClosed(more, at), at + 1));
        const string part(more.substr(at, to - at));
        if (function > at)
        {
            text += placeholder(blocks_.size());
            blocks_.append(part);
        }
        else
        {
            text += part;
        }
        at = to;
    }
    return text;
}


Foam::string Foam::misfit::functionBlocks::restored(string text) const
{
    forAll(blocks_, i)
    {
        const string its(placeholder(i));
        const size_t at = text.find(its);
        if (at != string::npos)
        {
            text.replace(at, its.size(), blocks_[i]);
        }
    }
    return text;
}
