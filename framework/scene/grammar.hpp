// SPDX-License-Identifier: MIT
// The scene language, in pieces: bodies, forces, and the scene that holds them.
#pragma once

#include "scene/keys.hpp"
#include "scene/mesh_library.hpp"
#include "scene/scene.hpp"

namespace rigor {

constexpr std::size_t most_bodies = 100'000, most_shapes = 200'000;
constexpr std::size_t most_scene_tetrahedra = 200'000;

/// Appends the body of an entry of "bodies", or all bodies of its grid.
/// @throws Mistake
void read_body(const Value& value, MeshLibrary& meshes, std::vector<BodyDescription>& bodies);

/// A shape, an object of one key.
/// @throws Mistake
Shape read_shape(const Value& value, MeshLibrary& meshes);

/// Copies of a body along a grid: {"count": [5, 4, 5], "spacing": [1.1, 1.1, 1.1], …}.
/// @throws Mistake
void read_grid(const Value& value, const BodyDescription& body,
               std::vector<BodyDescription>& bodies);

/// Appends the deformable solid of an entry of "solids".
/// @throws Mistake
void read_solid(const Value& value, MeshLibrary& meshes, std::vector<SolidDescription>& solids);

/// The mesh of a solid, an object of one kind or of a file.
/// @throws Mistake
std::shared_ptr<const TetrahedralMesh> read_solid_mesh(const Value& value, MeshLibrary& meshes);

/// What holds and pulls a solid's nodes, once its mesh and its place are known.
/// @throws Mistake
std::vector<Handle> read_handles(const Value& value, const SolidDescription& solid);
std::vector<NodeLoad> read_loads(const Value& value, const SolidDescription& solid);

/// Springs and forces. Their points are in the frames of the bodies as written.
/// @throws Mistake
std::vector<Spring> read_springs(const Value& value, const std::vector<BodyDescription>& bodies);
std::vector<AppliedForce> read_forces(const Value& value,
                                      const std::vector<BodyDescription>& bodies);

/// Where to look from, and what to draw besides the bodies.
/// @throws Mistake
Camera read_camera(const Value& value);
Overlays read_overlays(const Value& value);

/// Every key of the language, object by object, for the documentation and its test.
std::vector<KeyMeaning> scene_language();

void orientation_meanings(std::vector<KeyMeaning>& meanings);
void shape_meanings(std::vector<KeyMeaning>& meanings);
void body_meanings(std::vector<KeyMeaning>& meanings);
void grid_meanings(std::vector<KeyMeaning>& meanings);
void solid_meanings(std::vector<KeyMeaning>& meanings);
void tetrahedra_meanings(std::vector<KeyMeaning>& meanings);
void handle_meanings(std::vector<KeyMeaning>& meanings);
void force_meanings(std::vector<KeyMeaning>& meanings);
void picture_meanings(std::vector<KeyMeaning>& meanings);

template <class T>
void add_meanings(std::string_view object, Keys<T> keys, std::vector<KeyMeaning>& meanings)
{
    for (const Key<T>& key : keys)
        meanings.push_back({object, key.name, key.meaning});
}

} // namespace rigor
