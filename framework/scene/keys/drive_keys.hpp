// SPDX-License-Identifier: MIT
// The keys of a drive, which is the prescribed motion of a body.
#pragma once

#include "scene/description/scene.hpp"
#include "scene/language/json.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Reads a drive, except for its first position and orientation: they are those of the body, and
/// `make_recorded_world` sets them.
/// @throws Mistake
Drive read_drive(const Value& value);

void drive_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
