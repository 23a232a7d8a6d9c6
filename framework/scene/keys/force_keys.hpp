// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Reads springs. Their points are as in the file: in the frame of a body, or in the world where no
/// body is named.
/// @throws Mistake
std::vector<Spring> read_springs(const Value& value, const std::vector<BodyDescription>& bodies);

/// The result of `read_forces`: forces with their points as in the file, and the indices of those
/// whose points are in world space.
struct ForcesRead {
    std::vector<AppliedForce> forces;
    std::vector<int> in_world;
};
ForcesRead read_forces(const Value& value, const std::vector<BodyDescription>& bodies);

/// Reads the laws of pairs of bodies: restitution, friction, and whether the two collide. The
/// result is sorted by the indices of the bodies.
/// @throws Mistake
std::vector<PairLaw> read_pairs(const Value& value, const std::vector<BodyDescription>& bodies);

void force_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
