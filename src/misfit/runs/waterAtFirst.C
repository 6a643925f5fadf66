// SPDX-License-Identifier: GPL-3.0-or-later
// How much water a finished run began with.

#include "waterAtFirst.H"

#include "OSspecific.H"

#include <cstdlib>
#include <fstream>
#include <string>

Foam::scalar Foam::misfit::waterAtFirst(const fileName& caseFolder)
{
    const std::string words("Phase-1 volume fraction = ");
    for (const fileName& log : readDir(caseFolder, fileName::FILE))
    {
        if (log.compare(0, 4, "log.") != 0)
        {
            continue;
        }
        std::ifstream is(caseFolder/log);
        for (std::string line; std::getline(is, line);)
        {
            if (line.compare(0, words.size(), words) == 0)
            {
                return std::atof(line.c_str() + words.size());
            }
        }
    }
    return -1;
}
