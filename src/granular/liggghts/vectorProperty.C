// SPDX-License-Identifier: GPL-3.0-or-later
// A vector that LIGGGHTS keeps with each grain.

#include "vectorProperty.H"

#include <liggghts/modify.h>

LAMMPS_NS::FixPropertyAtom* Foam::addVectorProperty
(
    LAMMPS_NS::Modify& modify,
    const char* name,
    const char* initial
)
{
    // id, group, style, variable, shape, in restarts, to ghosts, from ghosts,
    // three initial values
    const char* args[] =
    {
        name, "all", "property/atom", name, "vector", "yes", "no", "no",
        initial, initial, initial
    };

    return modify.add_fix_property_atom(11, const_cast<char**>(args), name);
}
