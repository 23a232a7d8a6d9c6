// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"
#include "scene/language/keys.hpp"

namespace rigor {

/// Reads an orientation: {"axis": …, "degrees": …}, {"quaternion": [s, x, y, z]} or
/// {"euler_degrees": [roll, pitch, yaw]}, which are rotations about the fixed axes x, y and z, in
/// this order.
/// @throws Mistake
Quaternion orientation(const Value& value);

void orientation_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
