// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/bounds/bounds.hpp"

#include <vector>

namespace rigor {

/// Two bodies, body1 < body2, of which one moves: neither static nor asleep.
struct BodyPair {
    int body1 = 0, body2 = 0;

    bool operator==(const BodyPair&) const = default;
    auto operator<=>(const BodyPair&) const = default;
};

/// The pairs of bodies that may come near each other for some steps. Each body has a room, its bounds and
/// something to spare; until one leaves its room, those whose rooms do not overlap cannot meet (Verlet 1967,
/// "Computer \"experiments\" on classical fluids", Phys. Rev. 159).
struct PairMemory {
    enum class Kind : char { moving, still, endless };

    std::vector<Bounds> rooms;   // of each body; none: nothing is known
    std::vector<Kind> kinds;     // of each body, when the rooms were made
    std::vector<BodyPair> pairs; // whose rooms overlap, in ascending order
};

} // namespace rigor
