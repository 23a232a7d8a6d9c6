// SPDX-License-Identifier: MIT
// Reads inertia tensors.
#pragma once

#include "formulas/types.hpp"
#include "scene/language/json.hpp"

namespace rigor {

/// Reads an inertia tensor: three moments, or the three rows of a symmetric matrix [kg m²].
/// @throws Mistake also if no matter can have this inertia: if a principal moment is negative or
///         larger than the sum of the other two
Matrix3d inertia(const Value& value);

} // namespace rigor
