// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a function that fails, as text, instead of the end of the program.

#include "failureOf.H"
#include "exceptionGuard.H"
#include "IOstreams.H"

Foam::string Foam::misfit::failureOf(const std::function<void()>& attempts)
{
    try
    {
        const exceptionGuard guard(FatalError);
        const exceptionGuard guardIO(FatalIOError);
        attempts();
        return string();
    }
    catch (const Foam::IOerror& e)
    {
        return
            e.message() + " in " + e.ioFileName() + " at line "
          + Foam::name(e.ioStartLineNumber());
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }
}
