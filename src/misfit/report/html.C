// SPDX-License-Identifier: GPL-3.0-or-later
// Words, numbers and tables of a page.

#include "html.H"
#include "report.H"

#include "base64Layer.H"

#include <cmath>
#include <fstream>
#include <sstream>


std::string Foam::misfit::html::escaped(const std::string& text)
{
    std::string safe;
    for (const char c : text)
    {
        safe +=
            c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;"
          : std::string(1, c);
    }
    return safe;
}


std::string Foam::misfit::html::table
(
    const row& head,
    const std::vector<row>& rows
)
{
    if (rows.empty())
    {
        return "";
    }
    std::string text("<table>\n<tr>");
    for (const std::string& cell : head)
    {
        text += "<th>" + escaped(cell) + "</th>";
    }
    text += "</tr>\n";
    for (const row& r : rows)
    {
        text += "<tr>";
        for (const std::string& cell : r)
        {
            text += "<td>" + escaped(cell) + "</td>";
        }
        text += "</tr>\n";
    }
    return text + "</table>\n";
}


std::string Foam::misfit::html::header(const std::string& title)
{
    return
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<title>" + escaped(title) + "</title>\n<style>"
        "body{font:16px/1.5 sans-serif;max-width:62em;margin:2em auto;"
        "padding:0 1em;color:#222}"
        "table{border-collapse:collapse;margin:.5em 0}"
        "td,th{border-bottom:1px solid #ccc;padding:.2em .8em;text-align:left;"
        "vertical-align:top}"
        "img{max-width:100%}.verdict{background:#eef3f8;padding:1em;"
        "font-size:1.2em}h2{margin-top:2em}</style></head><body>\n"
        "<h1>" + escaped(title) + "</h1>\n";
}


std::string Foam::misfit::html::figure
(
    const fileName& file,
    const std::string& words
)
{
    std::ifstream is(file, std::ios::binary);
    const std::string bytes
    (
        (std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>()
    );
    std::ostringstream os;
    base64Layer encode(os);
    encode.write(bytes.data(), bytes.size());
    encode.close();
    return
        "<p><img alt=\"" + escaped(words) + "\" src=\"data:image/png;base64,"
      + os.str() + "\"><br>" + escaped(words) + "</p>\n";
}


std::string Foam::misfit::html::number(const scalar value)
{
    return
        value > 1e5 ? "more than 100000"
      : value < -1e5 ? "less than -100000" : shortNumber(value);
}


std::string Foam::misfit::html::percent(const scalar share)
{
    return
        share > 10 ? "more than 1000 %"
      : share < -10 ? "less than -1000 %"
      : shortNumber(std::round(100*share)) + " %";
}
