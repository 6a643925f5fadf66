// SPDX-License-Identifier: GPL-3.0-or-later
// Makes fixes of our own known to LIGGGHTS.

#include "fixStyles.H"

#include <map>
#include <string>

#include <liggghts/lammps.h>
#include <liggghts/modify.h>

namespace
{
    using fixMap = std::map<std::string, Foam::fixCreator>*;

    fixMap& stylesOf(LAMMPS_NS::Modify& modify);

    //- The table of styles is private in LIGGGHTS 3.8, which offers no other
    //  way to a fix of one's own. Naming a private member in an explicit
    //  instantiation is allowed by the standard
    template<fixMap LAMMPS_NS::Modify::*styles>
    struct privateStyles
    {
        friend fixMap& stylesOf(LAMMPS_NS::Modify& modify)
        {
            return modify.*styles;
        }
    };

    template struct privateStyles<&LAMMPS_NS::Modify::fix_map>;
}


void Foam::addFixStyle
(
    LAMMPS_NS::LAMMPS* lmp,
    const char* name,
    const fixCreator creator
)
{
    (*stylesOf(*lmp->modify))[name] = creator;
}
