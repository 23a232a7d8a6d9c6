// SPDX-License-Identifier: MIT
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Reads springs and forces. Their points are in the frames of the bodies, as in the file.
/// @throws Mistake
std::vector<Spring> read_springs(const Value& value, const std::vector<BodyDescription>& bodies);
std::vector<AppliedForce> read_forces(const Value& value,
                                      const std::vector<BodyDescription>& bodies);

void force_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
