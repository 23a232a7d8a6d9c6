// SPDX-License-Identifier: MIT
// How deep bodies overlap after a step, and how thick bodies are, with which this depth is
// compared.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"

#include <vector>

namespace rigor {

/// The largest number of bodies of an island that a step computes more than once: in adaptive
/// substeps, or with the flight of bodies that bounced or that contacts hold (bounced_flight.hpp,
/// supported_flight.hpp). In a larger island this would take too much time. Chosen by trial.
inline constexpr std::size_t most_refined = 32;

/// The smallest extent of a body's thinnest part, without planes [m]. It is infinity if all parts
/// are planes.
double thickness(const RigidBody& body);

/// Measures how deep bodies overlap.
class Overlap {
public:
    /// Both references have to stay valid.
    /// @param states  one for each body of the world; they take the place of the bodies' own states
    Overlap(const World& world, const std::vector<RigidState>& states)
        : world_(world), states_(states)
    {
    }

    /// The largest depth of the contacts of bodies i < j [m]. It is 0 if they do not overlap.
    double depth(int i, int j);

private:
    const World& world_;
    const std::vector<RigidState>& states_;
    std::vector<Pose> poses_; // one for each body; those of pairs that were measured are set
};

} // namespace rigor
