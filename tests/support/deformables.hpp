// SPDX-License-Identifier: MIT
// Deformable solids that tests and benchmarks share.
#pragma once

#include "deformable/deformable.hpp"
#include "geometry/tetrahedra.hpp"
#include "support/random.hpp"

namespace rigor::testing {

inline SolidMaterial soft_material()
{
    SolidMaterial material;
    material.density = 1000;
    material.youngs_modulus = 1e5;
    material.poisson_ratio = 0.3;
    return material;
}

/// A block whose nodes are moved by up to a fifth of a cell.
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

inline DeformableWorld world_of(Deformable solid)
{
    DeformableWorld world;
    world.rigid.formulas_are_reference = true;
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
