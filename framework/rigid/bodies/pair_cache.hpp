// SPDX-License-Identifier: MIT
// Cache of the pairs of bodies that may meet, kept from step to step.
#pragma once

#include "geometry/bounds/bounds.hpp"

#include <vector>

namespace rigor {

/// Two bodies with body1 < body2. At least one of them can move: it is not still
/// (`RigidBody::is_still`).
struct BodyPair {
    int body1 = 0, body2 = 0;

    bool operator==(const BodyPair&) const = default;
    auto operator<=>(const BodyPair&) const = default;
};

/// The pairs of bodies that may come near each other during the next steps. Each body has fat
/// bounds; for a moving body these are its bounds enlarged by a margin, for any other body just its
/// bounds. As long as every body stays within its fat bounds, only pairs whose fat bounds overlap
/// can meet (Verlet 1967, "Computer \"experiments\" on classical fluids", Phys. Rev. 159).
struct PairCache {
    enum class Kind : char {
        moving,
        still,     // see `RigidBody::is_still`
        unbounded, // a part of the body is a plane
    };

    std::vector<Bounds> fat_bounds; // one for each body; empty if the cache is empty
    std::vector<Kind> kinds;        // kind of each body at the time when the fat bounds were made
    // The pairs that `near_pairs` (detection/broad_phase) found with the fat bounds, sorted by
    // `body1`, then `body2`.
    std::vector<BodyPair> pairs;
};

} // namespace rigor
