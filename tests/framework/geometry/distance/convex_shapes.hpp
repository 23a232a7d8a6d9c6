// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/shape.hpp"
#include "geometry/shapes/solid_mesh.hpp"

namespace rigor::testing {

inline Shape mesh_shape(const TriangleMesh& triangles)
{
    return Mesh{std::make_shared<SolidMesh>(triangles)};
}

/// One shape of each convex kind, and several of a kind where proportions matter.
inline const std::vector<Shape>& convex_shapes()
{
    static const std::vector<Shape> all = {
        Box{{1, 1.5, 0.6}},           Cylinder{0.5, 1.2},
        Cylinder{0.9, 0.3},           Cone{0.6, 1.2},
        Ellipsoid{{0.4, 0.9, 0.6}},   mesh_shape(voussoir_mesh(0.8, 1.5, 40, 0.7)),
        mesh_shape(icosphere(0.7, 2))};
    return all;
}

} // namespace rigor::testing
