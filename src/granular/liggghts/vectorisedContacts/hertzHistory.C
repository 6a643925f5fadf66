// SPDX-License-Identifier: GPL-3.0-or-later
// The contact law "hertz tangential history" for many contacts at once.

#include "hertzHistory.H"

#include <cmath>

namespace
{
    using namespace Foam;

    //- Twice the root of 5/6, of the dashpots of a Hertz contact (Antypov &
    //  Elliott 2011, EPL 94:50004)
    constexpr double dashpot = 2*0.91287092917527685576161630466800355658790782;


    // Always inline: a call would keep the loop over contacts from being vectorised

    //- Tangential force of a contact with a normal force Fn, for a stretch of its
    //  spring; keeps the stretch, cut where the contact slides. kt and gt are those of
    //  spring and dashpot
    [[gnu::always_inline]] inline triple tangentialForce
    (
        contactBatch& c,
        const int k,
        const triple& stretch,
        const triple& slip,
        const double Fn,
        const double kt,
        const double gt
    )
    {
        const double spring = kt*std::sqrt(dot(stretch, stretch));
        const double most = c.friction[k]*std::fabs(Fn);
        const bool slides = spring > most;
        const triple held = stretch*(-kt);
        const triple slid = held*(most/(slides ? spring : 1));
        const triple stuck = held - slip*gt;
        const double unit = slides ? kt : 1;

        c.stretch.set
        (
            k,
            {
                slides ? -slid.x/unit : stretch.x,
                slides ? -slid.y/unit : stretch.y,
                slides ? -slid.z/unit : stretch.z
            }
        );

        return
        {
            slides ? slid.x : stuck.x,
            slides ? slid.y : stuck.y,
            slides ? slid.z : stuck.z
        };
    }


    //- Torque of the rolling spring: it takes the stiffness of the contact, and yields
    //  at its limit
    [[gnu::always_inline]] inline triple springTorque
    (
        contactBatch& c,
        const int k,
        const triple& normal,
        const triple& spin,
        const double stiffness,
        const double limit,
        const double dt
    )
    {
        triple roll =
            c.springTorque(k)
          + (spin - normal*dot(spin, normal))*(dt*stiffness);

        const double magnitude = std::sqrt(dot(roll, roll));
        const bool yields = magnitude > limit;
        const double part = limit/(yields ? magnitude : 1);

        roll.x = yields ? roll.x*part : roll.x;
        roll.y = yields ? roll.y*part : roll.y;
        roll.z = yields ? roll.z*part : roll.z;

        c.springTorque.set(k, roll);
        return roll;
    }


    //- Constant torque against the spin, of an elastic load kn*overlap. LIGGGHTS's
    //  order of factors, which differs at walls
    template<bool wall>
    [[gnu::always_inline]] inline triple constantTorque
    (
        const triple& normal,
        const triple& spin,
        const double rollingFriction,
        const double kn,
        const double overlap,
        const double radius
    )
    {
        const double magnitude = std::sqrt(dot(spin, spin));
        const double unlessZero = magnitude > 0 ? magnitude : 1;
        triple roll{0, 0, 0};

        if constexpr (wall)
        {
            const double load = rollingFriction*(overlap*kn);
            roll =
            {
                load*spin.x/unlessZero*radius,
                load*spin.y/unlessZero*radius,
                load*spin.z/unlessZero*radius
            };
        }
        else
        {
            const double limit = rollingFriction*kn*overlap*radius;
            roll = spin*(limit/unlessZero);
        }
        return roll - normal*dot(roll, normal);
    }


    template<rollingFriction rolling, bool wall>
    void forces(contactBatch& c, const int n, const double dt)
    {
        #pragma GCC ivdep
        for (int k = 0; k < n; ++k)
        {
            const triple d = c.distance(k);
            const double ri = c.radiusI[k];
            const double rj = wall ? 0 : c.radiusJ[k];
            const double mi = c.massI[k];
            const double mj = wall ? 0 : c.massJ[k];
            const triple spinI = c.spinI(k);
            const triple spinJ = wall ? triple{0, 0, 0} : c.spinJ(k);

            const double r =
                wall ? ri - c.overlap[k] : std::sqrt(c.distanceSquared[k]);
            const double rinv = 1/r;
            const triple normal = d*rinv;
            const double overlap = (wall ? ri : ri + rj) - r;
            const double armI = ri - 0.5*(wall ? c.overlap[k] : overlap);
            const double armJ = rj - 0.5*overlap;
            const triple turning =
                wall ? spinI*armI*rinv : (spinI*armI + spinJ*armJ)*rinv;

            // Velocity of the surfaces past each other
            const triple U = c.velocity(k);
            const double Un = dot(U, normal);
            const triple slip =
                U - normal*Un - cross(turning, d);

            const double mass = wall ? mi : mi*mj/(mi + mj);
            const double radius = wall ? ri : ri*rj/(ri + rj);
            const double a = std::sqrt(radius*overlap);
            const double Sn = 2*c.young[k]*a;
            const double kt = 8*c.shear[k]*a;
            const double kn = 4./3*c.young[k]*a;
            const double damping = -dashpot*c.damping[k];
            const double gn = damping*std::sqrt(Sn*mass);
            const double gt = damping*std::sqrt(kt*mass);

            const double Fn = -gn*Un + kn*overlap;

            triple stretch = c.stretch(k) + slip*dt;
            stretch = stretch - normal*dot(stretch, normal);

            const triple Ft = tangentialForce(c, k, stretch, slip, Fn, kt, gt);

            const triple spin = wall ? turning : spinI - spinJ;
            triple roll{0, 0, 0};

            if constexpr (rolling == rollingFriction::epsd2)
            {
                const double limit =
                    std::fabs(Fn)*radius*c.rollingFriction[k];
                roll = springTorque
                (
                    c, k, normal, spin, kt*radius*radius, limit, dt
                );
            }
            else if constexpr (rolling == rollingFriction::cdt)
            {
                roll = constantTorque<wall>
                (
                    normal, spin, c.rollingFriction[k], kn, overlap, radius
                );
            }

            const triple turn = cross(normal, Ft);
            c.force.set(k, normal*Fn + Ft);
            c.torqueI.set(k, turn*(-armI) - roll);
            c.torqueJ.set(k, turn*(-armJ) + roll);
        }
    }
}


void Foam::hertzHistory
(
    contactBatch& contacts,
    const int n,
    const double dt,
    const rollingFriction rolling,
    const bool wall
)
{
    const auto choose = [&](auto between, auto atWall)
    {
        (wall ? atWall : between)(contacts, n, dt);
    };

    switch (rolling)
    {
        case rollingFriction::off:
            return choose
            (
                forces<rollingFriction::off, false>,
                forces<rollingFriction::off, true>
            );

        case rollingFriction::cdt:
            return choose
            (
                forces<rollingFriction::cdt, false>,
                forces<rollingFriction::cdt, true>
            );

        case rollingFriction::epsd2:
            return choose
            (
                forces<rollingFriction::epsd2, false>,
                forces<rollingFriction::epsd2, true>
            );
    }
}
