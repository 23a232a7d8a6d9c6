// SPDX-License-Identifier: MIT
// Correct copies of cracked elements (A7.7), with a switch for each mistake.
#pragma once

#include "mistakes/fracture/cutting.hpp"

namespace rigor::cutting {

/// The rules of `virtual_nodes` (A7.7); each mistake changes one.
struct CopyRules {
    bool joins_always = false;       // even if no corner is real in both copies
    bool joins_only_corners = false; // only real corners, not the whole face
    bool on_plane_is_below = false;
    bool first_crack_only = false;
    bool whole_shares = false;  // each copy has the whole volume
    bool corner_shares = false; // a quarter of the volume for each real corner
    bool drops_unused = false;  // vertices that no tetrahedron uses
    bool clips_all = false;     // clips each part by every crack through the tetrahedron
    bool empty_stays = false;   // no crack divides a part without matter
    bool sixteen_bits = false;  // for the numbers of copies
    double nearly_on_plane = 0; // a height below this share of the largest one counts as 0
    double sliver = 0;          // a piece with less of the tetrahedron is not cut any more
};

/// The share of a tetrahedron's volume on the given sides of all planes. Recursive: an edge that
/// crosses the first plane is cut there, which splits the tetrahedron in two. By mistake, a piece
/// with less volume than `sliver` is on the side of its farthest vertex.
///
/// @param piece   barycentric coordinates of the corners, one column per corner
/// @param planes  for each plane the heights of the four original corners, and whether the part is
///                above it
inline double share(const Eigen::Matrix4d& piece,
                    std::vector<std::pair<Eigen::Vector4d, bool>> planes, double sliver = 0)
{
    const double volume = std::abs(piece.determinant());
    if (planes.empty()) return volume;
    const auto [plane, is_above] = planes.front();
    const Eigen::Vector4d h = piece.transpose() * plane * (is_above ? 1 : -1);
    Eigen::Index i = 0, j = 0;
    const double tiny = 2e-15 * plane.cwiseAbs().maxCoeff(); // rounding of the heights
    const double highest = h.maxCoeff(&i), lowest = h.minCoeff(&j);
    const bool is_far_below = is_above ? highest < -lowest : highest <= -lowest;
    if (highest <= tiny || (volume < sliver && is_far_below)) return 0;
    if (lowest >= -tiny || volume < sliver) {
        planes.erase(planes.begin());
        return share(piece, planes, sliver);
    }
    const double t = h[i] / (h[i] - h[j]);
    Eigen::Matrix4d first = piece, second = piece;
    first.col(j) = second.col(i) = (1 - t) * piece.col(i) + t * piece.col(j);
    return share(first, planes, sliver) + share(second, planes, sliver);
}

struct Part {
    Tetrahedron real = {1, 1, 1, 1};
    std::vector<std::pair<Eigen::Vector4d, bool>> planes; // the planes that bound it
};

inline std::vector<Part> parts_of(const CopyRules& rules,
                                  const std::vector<Eigen::Vector4d>& planes)
{
    std::vector<Part> parts(1);
    for (const Eigen::Vector4d& h : planes)
        for (std::size_t i = 0, count = parts.size(); i < count; ++i) {
            Part above = parts[i], below = parts[i];
            for (int c = 0; c < 4; ++c) {
                const bool is_above = rules.on_plane_is_below ? h[c] > 0 : h[c] >= 0;
                (is_above ? below : above).real[c] = 0;
            }
            const Tetrahedron none = {0, 0, 0, 0};
            if (above.real == none || below.real == none) continue;
            if (rules.empty_stays && share(Eigen::Matrix4d::Identity(), parts[i].planes) == 0)
                continue;
            above.planes.push_back({h, true});
            below.planes.push_back({h, false});
            parts[i] = above;
            parts.push_back(below);
        }
    std::sort(parts.begin(), parts.end(),
              [](const Part& a, const Part& b) { return a.real > b.real; });
    return parts;
}

inline double share_of(const CopyRules& rules, const Part& part,
                       const std::vector<Eigen::Vector4d>& planes)
{
    const int corners = std::accumulate(part.real.begin(), part.real.end(), 0);
    if (rules.whole_shares) return 1;
    if (rules.corner_shares) return corners / 4.0;
    if (!rules.clips_all) return share(Eigen::Matrix4d::Identity(), part.planes, rules.sliver);
    std::vector<std::pair<Eigen::Vector4d, bool>> all;
    for (const Eigen::Vector4d& h : planes) {
        const int own = corner_of(part.real, 1);
        if ((h.array() >= 0).any() && (h.array() < 0).any()) all.push_back({h, h[own] >= 0});
    }
    return share(Eigen::Matrix4d::Identity(), all);
}

inline EmbeddedMesh copies_by(const CopyRules& rules, const TetrahedralMesh& mesh,
                              const std::vector<ElementCrack>& cracks)
{
    std::vector<std::vector<Eigen::Vector4d>> planes(mesh.tetrahedra.size());
    for (const ElementCrack& crack : cracks) {
        Eigen::Vector4d h;
        for (int c = 0; c < 4; ++c)
            h[c] = crack.normal.dot(mesh.vertices[mesh.tetrahedra[crack.tetrahedron][c]] -
                                    crack.point);
        for (double& height : h)
            if (std::abs(height) < rules.nearly_on_plane * h.cwiseAbs().maxCoeff()) height = 0;
        if (rules.first_crack_only && !planes[crack.tetrahedron].empty()) continue;
        planes[crack.tetrahedron].push_back(h);
    }

    EmbeddedMesh result;
    std::vector<std::vector<int>> copies(mesh.tetrahedra.size());
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const std::vector<Part> parts = parts_of(rules, planes[t]);
        for (const Part& part : parts) {
            const int next = static_cast<int>(result.parents.size());
            copies[t].push_back(rules.sixteen_bits ? next % (1 << 16) : next);
            result.parents.push_back(static_cast<int>(t));
            result.real.push_back(part.real);
            result.fractions.push_back(share_of(rules, part, planes[t]));
            result.mesh.tetrahedra.push_back(mesh.tetrahedra[t]);
        }
    }

    Corners corners(result.parents.size());
    for (const auto& [face, sharing] : faces_of(mesh)) {
        if (sharing.size() != 2) continue;
        const Tetrahedron &t1 = mesh.tetrahedra[sharing[0]], &t2 = mesh.tetrahedra[sharing[1]];
        for (int copy1 : copies[sharing[0]])
            for (int copy2 : copies[sharing[1]]) {
                const auto is_real = [&](int v) {
                    return result.real[copy1][corner_of(t1, v)] == 1 &&
                           result.real[copy2][corner_of(t2, v)] == 1;
                };
                const bool is_joined =
                    rules.joins_always || is_real(face[0]) || is_real(face[1]) || is_real(face[2]);
                for (int v : face)
                    if (is_joined && (!rules.joins_only_corners || is_real(v)))
                        corners.join(copy1, corner_of(t1, v), copy2, corner_of(t2, v));
            }
    }
    result.vertex_parents = number_vertices(result.mesh.tetrahedra, corners);
    if (!rules.drops_unused)
        for (int v : unused_vertices(mesh))
            result.vertex_parents.push_back(v);
    for (int parent : result.vertex_parents)
        result.mesh.vertices.push_back(mesh.vertices[parent]);
    return result;
}

} // namespace rigor::cutting
