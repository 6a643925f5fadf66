// SPDX-License-Identifier: GPL-3.0-or-later
// OpenFOAM's stream for hashes with the function that its library lacks.

#include "hashStream.H"

#include "OSHA1stream.H"

bool Foam::hashStreamTakesCharacters()
{
    // Its table of virtual functions is made where the stream is. Ours is before
    // libOpenFOAM's, so the loader takes it for that library as well
    OSHA1stream os;
    os.stdStream().put(' ');

    return os.good();
}
