// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of material points that settle before they flow.

#include "pointSettling.H"

#include "keywords.H"

Foam::pointSettling::pointSettling
(
    materialPointMethod& method,
    const dictionary& bodies,
    const scalar start
)
:
    method_(method),
    now_(start)
{
    for (const word& body : method_.bodies())
    {
        const dictionary settling
        (
            keywords::sub
            (
                bodies.subDict(body), "settling", {"time", "damping"}
            )
        );
        const scalar rate = settling.getOrDefault<scalar>("damping", 20);
        const scalar time = settling.getOrDefault<scalar>("time", 0);

        if (!(rate > 0 && time >= 0))
        {
            FatalIOErrorInFunction(settling)
                << "settling of " << body << " has damping " << rate
                << " 1/s and time " << time << " s; damping must be above zero"
                << " and time not below." << exit(FatalIOError);
        }

        const label i = until_.size();
        until_.append(time);
        settles_.append(now_ < time*(1 - 1e-9));
        if (settles_[i])
        {
            method_.beginSettling(i, rate);
        }
    }
}


void Foam::pointSettling::end(const scalar interval)
{
    now_ += interval;

    forAll(until_, body)
    {
        if (settles_[body] && now_ >= until_[body]*(1 - 1e-9))
        {
            settles_[body] = false;
            method_.endSettling(body);
        }
    }
}
