// SPDX-License-Identifier: MIT
// The step of a world with a single body. It can touch nothing, so only free flight remains.
#pragma once

#include "rigid/bodies/world.hpp"

namespace rigor {

/// Whether a world has exactly one body, which moves and on which only gravity acts.
bool is_single_body(const World& world);

/// The step of such a world, without lists and stages.
/// @return an empty list: such a world has no contacts
std::vector<ContactRecord> step_single_body(World& world, double time_step);

} // namespace rigor
