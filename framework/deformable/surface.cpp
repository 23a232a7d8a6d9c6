// SPDX-License-Identifier: MIT
#include "deformable/clipped_element.hpp"
#include "geometry/tetrahedra.hpp"

#include <algorithm>

namespace rigor {

namespace {

// Collects triangles; the corners of elements become one point for each vertex of the mesh.
class Builder {
public:
    explicit Builder(const Deformable& solid)
        : solid_(solid), point_(solid.rest.vertices.size(), -1)
    {
    }

    void add_face(int element, int face, bool is_crack)
    {
        EmbeddedTriangle triangle{{0, 0, 0}, element, is_crack};
        for (int i = 0; i < 3; ++i)
            triangle.points[i] = corner(element, tetrahedron_faces[face][i]);
        surface_.triangles.push_back(triangle);
    }

    // A fan about the first vertex.
    void add_polygon(int element, const ClippedFace& face)
    {
        const int first = static_cast<int>(surface_.points.size());
        for (const Eigen::Vector4d& weights : face.weights)
            surface_.points.push_back({element, weights});
        for (int i = 2; i < static_cast<int>(face.weights.size()); ++i)
            surface_.triangles.push_back(
                {{first, first + i - 1, first + i}, element, face.is_crack});
    }

    EmbeddedSurface finish() { return std::move(surface_); }

private:
    int corner(int element, int corner)
    {
        int& p = point_[solid_.rest.tetrahedra[element][corner]];
        if (p < 0) {
            p = static_cast<int>(surface_.points.size());
            surface_.points.push_back({element, Eigen::Vector4d::Unit(corner)});
        }
        return p;
    }

    const Deformable& solid_;
    EmbeddedSurface surface_;
    std::vector<int> point_; // of each vertex of the mesh
};

// The boundary of the mesh itself.
EmbeddedSurface boundary_surface(const Deformable& solid)
{
    Builder builder(solid);
    const auto neighbours = face_neighbours(solid.rest);
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t)
        for (int f = 0; f < 4; ++f)
            if (neighbours[t][f] < 0)
                builder.add_face(t, f, !solid.crack_faces.empty() && solid.crack_faces[t][f]);
    return builder.finish();
}

// Whole elements show their faces on the solid's own surface, and those towards cracked elements, which a
// crack may lay open; parts of elements show all that bounds them.
EmbeddedSurface embedded_surface(const Deformable& solid)
{
    Builder builder(solid);
    const auto neighbours = face_neighbours(solid.uncracked);
    std::vector<char> is_cracked(neighbours.size(), 0);
    for (const ElementCrack& crack : solid.cracks)
        is_cracked[crack.tetrahedron] = 1;
    for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); ++t) {
        const int parent = solid.embedded.parents[t];
        if (is_cracked[parent]) {
            for (ClippedFace& face : clipped_element(solid, t)) {
                const bool is_outside = face.face >= 0 && neighbours[parent][face.face] < 0;
                face.is_crack = !is_outside;
                builder.add_polygon(t, face);
            }
            continue;
        }
        for (int f = 0; f < 4; ++f) {
            const int beyond = neighbours[parent][f];
            if (beyond < 0 || is_cracked[beyond]) builder.add_face(t, f, beyond >= 0);
        }
    }
    return builder.finish();
}

} // namespace

EmbeddedSurface drawn_surface(const Deformable& solid)
{
    return solid.embedded.parents.empty() ? boundary_surface(solid) : embedded_surface(solid);
}

} // namespace rigor
