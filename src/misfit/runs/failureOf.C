// SPDX-License-Identifier: GPL-3.0-or-later
// The error of a function that fails, as text, instead of the end of the program.

#include "failureOf.H"
#include "error.H"
#include "IOstreams.H"

Foam::string Foam::misfit::failureOf(const std::function<void()>& attempts)
{
    const bool threw = FatalError.throwExceptions();
    const bool threwIO = FatalIOError.throwExceptions();
    string failure;
    try
    {
        attempts();
    }
    catch (const Foam::IOerror& e)
    {
        failure =
            e.message() + " in " + e.ioFileName() + " at line "
          + Foam::name(e.ioStartLineNumber());
    }
    catch (const Foam::error& e)
    {
        failure = e.message();
    }
    FatalError.throwExceptions(threw);
    FatalIOError.throwExceptions(threwIO);
    return failure;
}
