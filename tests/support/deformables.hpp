// SPDX-License-Identifier: MIT
// Deformable solids that tests and benchmarks share.
#pragma once

#include "deformable/elasticity/totals.hpp"
#include "deformable/solid/deformable.hpp"
#include "deformable/solid/make_deformable.hpp"
#include "deformable/step/step.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"
#include "geometry/tetrahedra/tetrahedra_generators.hpp"
#include "support/random.hpp"

#include <algorithm>

namespace rigor::testing {

inline SolidMaterial soft_material()
{
    SolidMaterial material;
    material.density = 1000;
    material.youngs_modulus = 1e5;
    material.poisson_ratio = 0.3;
    return material;
}

/// A block of cells of 1 m whose nodes are moved by up to a fifth of a cell along each axis.
inline TetrahedralMesh random_mesh(Random& random)
{
    TetrahedralMesh mesh = block_tetrahedra({3, 2, 2}, {3, 2, 2});
    for (Vector3d& x : mesh.vertices)
        x += 0.2 * random.vector();
    return mesh;
}

inline Deformable solid_of(TetrahedralMesh mesh, const SolidMaterial& material)
{
    return make_deformable("solid", std::move(mesh), material, Matrix3d::Identity(),
                           Vector3d::Zero());
}

/// The nodes whose x is at one end of a mesh about the origin. @param side  -1 or +1
inline std::vector<int> end_nodes(const Deformable& solid, int side)
{
    double end = 0;
    for (const Vector3d& x : solid.rest.vertices)
        end = std::max(end, side * x.x());
    std::vector<int> nodes;
    for (int i = 0; i < static_cast<int>(solid.rest.vertices.size()); ++i)
        if (side * solid.rest.vertices[i].x() > end * (1 - 1e-9)) nodes.push_back(i);
    return nodes;
}

/// Pulls both ends of a solid apart, each by `distance` [m] along x, at constant speed until
/// `time` [s].
inline void pull_apart(Deformable& solid, double distance, double time)
{
    for (const int side : {-1, 1}) {
        Handle handle;
        handle.nodes = end_nodes(solid, side);
        handle.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                       {time, Vector3d(distance * side, 0, 0), Vector3d::Zero()}};
        solid.handles.push_back(handle);
    }
}

inline DeformableWorld world_of(Deformable solid)
{
    DeformableWorld world;
    world.rigid.settings.formulas_are_reference = true;
    world.solids.push_back(std::move(solid));
    return world;
}

/// A world with a floor at y = 0.
inline void add_floor(DeformableWorld& world)
{
    RigidBody floor;
    floor.name = "floor";
    floor.is_static = true;
    floor.parts = {Part{Plane{}, Vector3d::Zero(), Quaternion{}, 1000}};
    world.rigid.bodies.push_back(floor);
}

inline void run(DeformableWorld& world, double time_step, int steps)
{
    for (int i = 0; i < steps; ++i)
        step(world, time_step);
}

} // namespace rigor::testing
