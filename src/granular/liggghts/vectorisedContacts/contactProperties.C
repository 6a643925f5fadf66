// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of each pair of materials that a contact law needs, side by side.

#include "contactProperties.H"

#include <liggghts/property_registry.h>

void Foam::contactProperties::connect
(
    PropertyRegistry& registry,
    const rollingFriction rolling
)
{
    // LIGGGHTS's tables end with the last type of a grain or wall
    size_ = registry.max_type() + 1;
    table_.resize(size_*size_);

    const char* const name = "interDEMFoam's contacts";
    registry.connect("Yeff", young_, name);
    registry.connect("Geff", shear_, name);
    registry.connect("betaeff", damping_, name);
    registry.connect("coeffFrict", friction_, name);

    if (rolling != rollingFriction::off)
    {
        registry.connect("coeffRollFrict", rollingFriction_, name);
    }
}


void Foam::contactProperties::copy()
{
    for (int i = 1; i < size_; ++i)
    {
        for (int j = 1; j < size_; ++j)
        {
            table_[i*size_ + j] =
            {
                young_[i][j],
                shear_[i][j],
                damping_[i][j],
                friction_[i][j],
                rollingFriction_ ? rollingFriction_[i][j] : 0
            };
        }
    }
}
