// SPDX-License-Identifier: MIT
#include "deformable/deformable.hpp"

#include "geometry/tetrahedra.hpp"

namespace rigor {

namespace {

// The boundary of the mesh itself: a point for each of its vertices.
EmbeddedSurface boundary_surface(const Deformable& solid)
{
    EmbeddedSurface surface;
    std::vector<int> point(solid.rest.vertices.size(), -1);
    const auto neighbours = face_neighbours(solid.rest);
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t)
        for (int f = 0; f < 4; ++f) {
            if (neighbours[t][f] >= 0) continue;
            EmbeddedTriangle triangle;
            triangle.element = t;
            triangle.is_crack = !solid.crack_faces.empty() && solid.crack_faces[t][f];
            for (int i = 0; i < 3; ++i) {
                const int corner = tetrahedron_faces[f][i];
                int& p = point[solid.rest.tetrahedra[t][corner]];
                if (p < 0) {
                    p = static_cast<int>(surface.points.size());
                    surface.points.push_back({t, Eigen::Vector4d::Unit(corner)});
                }
                triangle.points[i] = p;
            }
            surface.triangles.push_back(triangle);
        }
    return surface;
}

} // namespace

EmbeddedSurface drawn_surface(const Deformable& solid)
{
    return boundary_surface(solid);
}

} // namespace rigor
