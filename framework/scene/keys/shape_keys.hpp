// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/shape.hpp"
#include "scene/language/keys.hpp"
#include "scene/meshes/mesh_library.hpp"

namespace rigor {

/// Reads a shape, which is an object with a single key: the kind of shape.
/// @throws Mistake
Shape read_shape(const Value& value, MeshLibrary& meshes);

void shape_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
