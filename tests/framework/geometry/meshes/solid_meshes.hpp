// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/meshes/generators.hpp"
#include "geometry/meshes/triangle.hpp"

#include <algorithm>

namespace rigor::testing {

/// Distance from a point to a mesh, found by testing every triangle [m].
inline double distance_to_triangles(const TriangleMesh& mesh, const Vector3d& p)
{
    double best = 1e300;
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        best = std::min(best, (nearest_on(triangle_of(mesh, t), p).point - p).norm());
    return best;
}

/// One mesh of each generator.
inline const std::vector<TriangleMesh>& solid_meshes()
{
    static const std::vector<TriangleMesh> all = {box_mesh({1, 2, 0.5}),
                                                  icosphere(1, 1),
                                                  torus_mesh(1, 0.3, 16, 8),
                                                  ring_mesh(0.5, 1, 0.3, 12),
                                                  cross_mesh(1, 0.3),
                                                  bowl_mesh(1, 0.2, 12),
                                                  gear_mesh(8, 1, 0.3, 0.3),
                                                  angle_mesh({1, 1, 0.4}, 0.3),
                                                  voussoir_mesh(1, 1.4, 30, 0.5),
                                                  ring_mesh(0.2, 0.3, 2, 48)};
    return all;
}

} // namespace rigor::testing
