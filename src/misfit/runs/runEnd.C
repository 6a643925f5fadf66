// SPDX-License-Identifier: GPL-3.0-or-later
// How a run ended, by the file that etc/misfitRun writes then.

#include "runEnd.H"
#include "textFile.H"

#include <algorithm>
#include <cstdlib>

Foam::string Foam::misfit::runEnd::reason() const
{
    const auto first = std::min(said_.find('\n'), said_.size() - 1) + 1;
    return said_.substr(first, said_.find('\n', first) - first);
}


Foam::misfit::runEnd::runEnd(const fileName& run)
:
    file_(run/"finished"),
    said_(contentOf(file_))
{}


Foam::string Foam::misfit::runEnd::failure() const
{
    if (isWell())
    {
        return string();
    }
    const string words(said_.substr(std::min(said_.find('\n'), said_.size())));
    return
        words.size()
      ? words
      : string("how it ended is not known: no reason stands in " + file_);
}


Foam::scalar Foam::misfit::runEnd::seconds() const
{
    return std::atof(said_.c_str() + std::min(said_.find(' '), said_.size()));
}


Foam::scalar Foam::misfit::runEnd::limit() const
{
    const string words(" took longer than ");
    const string why(reason());
    const auto at = why.find(words);
    return at == string::npos ? -1 : std::atof(why.c_str() + at + words.size());
}


bool Foam::misfit::runEnd::isFromOutside() const
{
    const string why(reason());
    return
        limit() >= 0 || why.find(" ended with 137") != string::npos
     || why.find(" ended with 143") != string::npos;
}
