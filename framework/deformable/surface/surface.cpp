// SPDX-License-Identifier: MIT
// Extracts the triangles that are drawn for a solid. Without virtual nodes they are the boundary of
// its mesh. With virtual nodes (Molino, Bao and Fedkiw 2004), a cracked element has one copy for
// each piece of its material, and the triangles bound the material of each copy: first its cracks,
// then the parts of its faces that no connected neighbor covers.
#include "deformable/surface/surface.hpp"

#include "deformable/surface/clipped_element.hpp"
#include "geometry/tetrahedra/tetrahedra.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace rigor {

namespace {

using Polygon = std::vector<Eigen::Vector4d>; // barycentric coordinates of its vertices

// Collects triangles. Points with the same weights of the same nodes become one point.
class Builder {
public:
    explicit Builder(const Deformable& solid)
        : solid_(solid), corner_(solid.rest.vertices.size(), -1)
    {
    }

    // Adds the polygon as a fan of triangles about its first vertex.
    void add_polygon(int element, const Polygon& polygon, bool is_crack)
    {
        std::vector<int> points;
        for (const Eigen::Vector4d& weights : polygon)
            points.push_back(point(element, weights));
        for (std::size_t i = 2; i < points.size(); ++i) {
            const std::array<int, 3> corners = {points[0], points[i - 1], points[i]};
            if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
                surface_.triangles.push_back({corners, element, is_crack});
        }
    }

    EmbeddedSurface finish() { return std::move(surface_); }

private:
    using PointKey = std::array<std::pair<int, long long>, 4>; // nodes and their weights

    // Weights are compared in units of 2⁻⁴⁰, so that weights that differ by rounding are equal.
    PointKey key_of(int element, const Eigen::Vector4d& weights) const
    {
        PointKey key;
        for (int i = 0; i < 4; ++i) {
            const long long share = std::llround(weights[i] * 0x1p40);
            key[i] = {share == 0 ? -1 : solid_.rest.tetrahedra[element][i], share};
        }
        std::sort(key.begin(), key.end());
        return key;
    }

    int point(int element, const Eigen::Vector4d& weights)
    {
        for (int i = 0; i < 4; ++i)
            if (weights[i] == 1)
                return known(corner_[solid_.rest.tetrahedra[element][i]], element, weights);
        return known(point_.try_emplace(key_of(element, weights), -1).first->second, element,
                     weights);
    }

    int known(int& number, int element, const Eigen::Vector4d& weights)
    {
        if (number < 0) {
            number = static_cast<int>(surface_.points.size());
            surface_.points.push_back({element, weights});
        }
        return number;
    }

    const Deformable& solid_;
    EmbeddedSurface surface_;
    std::vector<int> corner_;       // for each vertex of the mesh, its point, or -1 for none yet
    std::map<PointKey, int> point_; // indices of the points that are not at a vertex
};

Polygon whole_face(int face)
{
    Polygon polygon;
    for (const int i : tetrahedron_faces[face])
        polygon.push_back(Eigen::Vector4d::Unit(i));
    return polygon;
}

// The boundary of the mesh, for a solid without virtual nodes.
EmbeddedSurface boundary_surface(const Deformable& solid)
{
    Builder builder(solid);
    const auto neighbours = face_neighbours(solid.rest);
    for (int t = 0; t < static_cast<int>(neighbours.size()); ++t)
        for (int f = 0; f < 4; ++f)
            if (neighbours[t][f] < 0)
                builder.add_polygon(t, whole_face(f),
                                    !solid.crack_faces.empty() && solid.crack_faces[t][f]);
    return builder.finish();
}

// The material of a solid with virtual nodes, element by element.
class Matter {
public:
    explicit Matter(const Deformable& solid)
        : solid_(solid), neighbours_(face_neighbours(solid.uncracked)),
          is_cracked_(neighbours_.size(), 0), copies_(neighbours_.size()),
          parts_(solid.rest.tetrahedra.size())
    {
        for (const ElementCrack& crack : solid.cracks)
            is_cracked_[crack.tetrahedron] = 1;
        for (int t = 0; t < static_cast<int>(parts_.size()); ++t) {
            const int parent = solid.embedded.parents[t];
            copies_[parent].push_back(t);
            if (is_cracked_[parent]) parts_[t] = clipped_element(solid, t);
        }
    }

    // Adds what is visible of the element: its cracks, its faces on the boundary of the solid, and
    // the parts of its other faces that no connected neighbor covers.
    void show(int element, Builder& builder) const
    {
        const int parent = solid_.embedded.parents[element];
        for (const ClippedFace& part : parts_[element])
            if (part.face < 0) builder.add_polygon(element, part.weights, true);
        for (int f = 0; f < 4; ++f) {
            const int beyond = neighbours_[parent][f];
            if (beyond < 0)
                builder.add_polygon(element, matter_in(element, f), has_come_off(parent, f));
            else if (is_cracked_[parent] || is_cracked_[beyond])
                for (const Polygon& piece : open_pieces(element, f))
                    builder.add_polygon(element, piece, true);
        }
    }

private:
    // Whether an inverted element was separated at this face.
    bool has_come_off(int parent, int face) const
    {
        return !solid_.crack_faces.empty() && solid_.crack_faces[parent][face];
    }

    // The polygon of the material in a face of an element.
    Polygon matter_in(int element, int face) const
    {
        if (!is_cracked_[solid_.embedded.parents[element]]) return whole_face(face);
        for (const ClippedFace& part : parts_[element])
            if (part.face == face) return part.weights;
        return {};
    }

    std::vector<Polygon> open_pieces(int element, int face) const
    {
        std::vector<Polygon> open = {matter_in(element, face)};
        for (const int other : copies_[neighbours_[solid_.embedded.parents[element]][face]]) {
            const Polygon cover = matter_against(element, face, other);
            if (cover.empty()) continue;
            std::vector<Polygon> left;
            for (const Polygon& piece : open)
                for (Polygon& part : uncovered(piece, cover, face))
                    left.push_back(std::move(part));
            open = std::move(left);
        }
        return open;
    }

    // The polygon of the material of element `other` in a face of `element`. It is empty unless
    // both elements share the three nodes of the face, so that they cannot separate.
    Polygon matter_against(int element, int face, int other) const
    {
        const auto &nodes = solid_.rest.tetrahedra[element],
                   &others = solid_.rest.tetrahedra[other];
        // For each corner of `element`, the index of the same corner in `other`, or -1 for none.
        std::array<int, 4> corner = {-1, -1, -1, -1};
        int opposite = 0 + 1 + 2 + 3;
        for (const int i : tetrahedron_faces[face]) {
            const auto at = std::find(others.begin(), others.end(), nodes[i]);
            if (at == others.end()) return {};
            corner[i] = static_cast<int>(at - others.begin());
            opposite -= corner[i];
        }
        Polygon polygon = matter_in(other, opposite);
        for (Eigen::Vector4d& weights : polygon) {
            const Eigen::Vector4d of_other = weights;
            for (int i = 0; i < 4; ++i)
                weights[i] = corner[i] < 0 ? 0 : of_other[corner[i]];
        }
        return polygon;
    }

    const Deformable& solid_;
    // For each element of the uncracked mesh and each of its faces, the element beyond it, or -1.
    std::vector<std::array<int, 4>> neighbours_;
    std::vector<char> is_cracked_;
    std::vector<std::vector<int>> copies_; // for each element of the uncracked mesh, its copies
    // For each copy of a cracked element, the faces that bound its material.
    std::vector<std::vector<ClippedFace>> parts_;
};

EmbeddedSurface embedded_surface(const Deformable& solid)
{
    Builder builder(solid);
    const Matter matter(solid);
    for (int t = 0; t < static_cast<int>(solid.rest.tetrahedra.size()); ++t)
        matter.show(t, builder);
    return builder.finish();
}

} // namespace

EmbeddedSurface drawn_surface(const Deformable& solid)
{
    return solid.embedded.parents.empty() ? boundary_surface(solid) : embedded_surface(solid);
}

} // namespace rigor
