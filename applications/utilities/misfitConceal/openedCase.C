// SPDX-License-Identifier: GPL-3.0-or-later
// A concealed case once its key is open.

#include "openedCase.H"

#include "stringOps.H"

#include <algorithm>

namespace
{

using namespace Foam;
using namespace Foam::misfit;
using json = nlohmann::json;

using nameList = std::vector<std::string>;

nameList sorted(nameList all)
{
    std::sort(all.begin(), all.end());
    return all;
}


scalar begins(const openedCase& c, const window& w)
{
    const segment& s = c.data->segments[w.segment];
    return s.x[w.begin] - 0.5*s.span;
}


scalar ends(const openedCase& c, const window& w)
{
    const segment& s = c.data->segments[w.segment];
    return s.x[w.end - 1] + 0.5*s.span;
}

} // End anonymous namespace


std::vector<std::string> Foam::misfit::openedCase::truth() const
{
    nameList all;
    for (const json& m : key["mechanisms"])
    {
        all.push_back(m["name"]);
    }
    return sorted(all);
}


std::vector<std::string> Foam::misfit::openedCase::names() const
{
    return sorted(verdict["names"]);
}


bool Foam::misfit::openedCase::nothingWrong() const
{
    const nameList real(truth());
    const nameList said(names());
    return
        named() && std::includes(real.begin(), real.end(), said.begin(), said.end());
}


bool Foam::misfit::openedCase::hasTruthInSet() const
{
    const nameList real(truth());
    return
        said() == "set" && real.size()
     && statistics::contains(names(), real.front());
}


bool Foam::misfit::openedCase::setIsRight() const
{
    const nameList real(truth());
    const nameList said(names());
    return std::any_of(said.begin(), said.end(), [&](const std::string& one)
    {
        // The mechanisms of one of the set, or the fault of a sensor as it is worded
        const auto parts(stringOps::split(one, " and "));
        return
            (faulty().size() && one.find("of " + faulty()) != one.npos)
         || std::all_of(parts.begin(), parts.end(), [&](const auto& part)
            {
                return statistics::contains(real, part.str());
            });
    });
}


bool Foam::misfit::openedCase::isRight() const
{
    return
        said() == "set" ? setIsRight()
      : said() == "none" ? kind() == "null"
      : said() == "unknown" ? kind() == "outside"
      : blamesChannel() ? faulty().size() && names() == nameList({faulty()})
      : nothingWrong();
}


bool Foam::misfit::openedCase::blamesPhysics() const
{
    const nameList said(names());
    const bool aFault = std::any_of(said.begin(), said.end(), [&](const auto& name)
    {
        return name.find(faulty()) != name.npos;
    });
    return named() || (this->said() == "set" && !aFault);
}


std::optional<Foam::scalar> Foam::misfit::openedCase::overlap() const
{
    if (effect.places.empty())
    {
        return {};
    }
    scalar both = 0;
    scalar lengths = 0;
    for (const window& a : effect.places)
    {
        lengths += ends(*this, a) - begins(*this, a);
        for (const json& b : verdict["located"])
        {
            if (b["channel"] == data->segments[a.segment].name)
            {
                both += max
                (
                    min(ends(*this, a), b["to"].get<scalar>())
                  - max(begins(*this, a), b["from"].get<scalar>()),
                    0.0
                );
            }
        }
    }
    for (const json& b : verdict["located"])
    {
        lengths += b["to"].get<scalar>() - b["from"].get<scalar>();
    }
    return 2*both/lengths;
}


std::optional<Foam::scalar> Foam::misfit::openedCase::onset() const
{
    if (effect.places.empty())
    {
        return {};
    }
    scalar real = GREAT;
    scalar found = GREAT;
    scalar end = 0;
    for (const window& a : effect.places)
    {
        const segment& s = data->segments[a.segment];
        real = min(real, begins(*this, a));
        end = max(end, s.x[s.size - 1]);
    }
    for (const json& b : verdict["located"])
    {
        found = min(found, b["from"].get<scalar>());
    }
    const segment& s = data->segments.front();
    return 100*(found == GREAT ? end : mag(found - real))/(s.duration() + s.span);
}


std::optional<Foam::scalar> Foam::misfit::openedCase::sizeOff() const
{
    using size = std::optional<scalar>;
    return namedSize > 0 ? size(100*mag(namedSize/effect.noiseSNR - 1)) : size();
}
