// SPDX-License-Identifier: GPL-3.0-or-later
// Words for the kinds of advice.

#include "adviceNames.H"

const Foam::Enum<Foam::misfit::advice::kind> Foam::misfit::adviceNames
({
    {advice::kind::nothing, "nothing"},
    {advice::kind::notRun, "notRun"},
    {advice::kind::measure, "measure"},
    {advice::kind::elsewhere, "elsewhere"},
    {advice::kind::check, "check"}
});
