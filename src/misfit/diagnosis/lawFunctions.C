// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of dimensionless numbers: their names.

#include "lawFunctions.H"

const Foam::List<Foam::misfit::lawFunction>&
Foam::misfit::functionsOf(const elementFamily family)
{
    static const List<lawFunction> ofDrag
    ({
        {"factor", ""}, {"Re_p", "Re_p"}, {"voidFraction", "voidFraction"}
    });
    static const List<lawFunction> ofPush
    ({
        {"always", ""}, {"Fr2", "Fr"}, {"Fr2Re", "Re"}, {"solid", "voidFraction"}
    });
    return family == elementFamily::drag ? ofDrag : ofPush;
}
