// SPDX-License-Identifier: MIT
// The shapes that are meshes, with one reader for each kind.
#pragma once

#include "geometry/shapes/shape.hpp"
#include "scene/language/keys.hpp"
#include "scene/meshes/mesh_library.hpp"

#include <optional>

namespace rigor {

/// A shape that is being read, and the meshes of its scene.
struct ShapeDraft {
    MeshLibrary& meshes;
    std::optional<Shape> shape;
};

// The readers of shapes that are meshes. Each may throw a Mistake.
void read_ring(ShapeDraft& draft, const Value& value);
void read_cross(ShapeDraft& draft, const Value& value);
void read_bowl(ShapeDraft& draft, const Value& value);
void read_gear(ShapeDraft& draft, const Value& value);
void read_angle(ShapeDraft& draft, const Value& value);
void read_voussoir(ShapeDraft& draft, const Value& value);
void read_mesh(ShapeDraft& draft, const Value& value);

void mesh_meanings(std::vector<KeyMeaning>& meanings);

} // namespace rigor
