// SPDX-License-Identifier: GPL-3.0-or-later
// Lets the first rank print an error that all ranks meet.

#include "masterErrorsFirst.H"

#include "Pstream.H"

#include <csignal>
#include <cstdlib>
#include <iostream>

#include <unistd.h>

void Foam::masterErrorsFirst::wait()
{
    if (waited_)
    {
        return;
    }
    waited_ = true;

    // mpirun ends this rank by SIGTERM where the first one has printed the
    // error. Where it was a warning, the run goes on and may be stopped later
    const auto handler = std::signal(SIGTERM, SIG_DFL);

    // mpirun waits for so long until it ends the other ranks [s]
    const char* mpirun = std::getenv("OMPI_MCA_odls_base_sigkill_timeout");
    ::sleep(2 + (mpirun ? std::atoi(mpirun) : 1));
    std::signal(SIGTERM, handler);
}


Foam::masterErrorsFirst::int_type Foam::masterErrorsFirst::overflow(int_type c)
{
    wait();
    return shown_->sputc(traits_type::to_char_type(c));
}


std::streamsize Foam::masterErrorsFirst::xsputn(const char* text, std::streamsize n)
{
    wait();
    return shown_->sputn(text, n);
}


int Foam::masterErrorsFirst::sync()
{
    return shown_->pubsync();
}


Foam::masterErrorsFirst::masterErrorsFirst()
:
    shown_(std::cerr.rdbuf()),
    waited_(false)
{
    if (!Pstream::master())
    {
        std::cerr.rdbuf(this);
    }
}


Foam::masterErrorsFirst::~masterErrorsFirst()
{
    std::cerr.rdbuf(shown_);
}
