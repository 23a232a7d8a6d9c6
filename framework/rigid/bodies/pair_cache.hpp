// SPDX-License-Identifier: MIT
// The pairs of bodies that may meet, remembered from step to step.
#pragma once

#include "geometry/bounds/bounds.hpp"

#include <vector>

namespace rigor {

/// Two bodies, body1 < body2, at least one of which moves: it is neither static nor asleep.
struct BodyPair {
    int body1 = 0, body2 = 0;

    bool operator==(const BodyPair&) const = default;
    auto operator<=>(const BodyPair&) const = default;
};

/// The pairs of bodies that may come near each other during some steps. Each body has fat bounds, its
/// bounds with a margin around them. Until a body leaves its fat bounds, only pairs whose fat bounds
/// overlap can meet (Verlet 1967, "Computer \"experiments\" on classical fluids", Phys. Rev. 159).
struct PairCache {
    enum class Kind : char {
        moving,
        still,     // static or asleep
        unbounded, // has a plane
    };

    std::vector<Bounds> fat_bounds; // of each body; empty: the cache holds nothing
    std::vector<Kind> kinds;        // of each body, when the fat bounds were made
    std::vector<BodyPair> pairs;    // with overlapping fat bounds, in ascending order
};

} // namespace rigor
