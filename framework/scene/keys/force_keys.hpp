// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Reads springs and forces. Their points are as in the file.
/// @throws Mistake
std::vector<Spring> read_springs(const Value& value, const std::vector<BodyDescription>& bodies);

/// Forces, and the numbers of those whose points are in world space.
struct ForcesRead {
    std::vector<AppliedForce> forces;
    std::vector<int> in_world;
};
ForcesRead read_forces(const Value& value, const std::vector<BodyDescription>& bodies);

/// Reads the laws of pairs of bodies, sorted by their bodies.
/// @throws Mistake
std::vector<PairLaw> read_pairs(const Value& value, const std::vector<BodyDescription>& bodies);

void force_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
