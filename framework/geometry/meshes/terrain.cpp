// SPDX-License-Identifier: MIT
// Closes an open surface. The bottom is a flat copy of the surface with its faces turned over, and
// the walls have two triangles below each edge of the border.
#include "geometry/meshes/terrain.hpp"

#include "geometry/meshes/mesh_edges.hpp"
#include "geometry/meshes/mesh_error.hpp"

#include <algorithm>
#include <limits>

namespace rigor {

namespace {

void check_seen_from_above(const TriangleMesh& surface, const std::vector<int>& lines)
{
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        const auto& v = surface.vertices;
        if (!((v[b] - v[a]).cross(v[c] - v[a]).y() > 0))
            throw MeshError(lines.empty() ? 0 : lines[t],
                            "expected a terrain whose faces turn counter-clockwise seen from "
                            "above, found one that does not");
    }
}

} // namespace

TriangleMesh solid_below(const TriangleMesh& surface, double depth, const std::vector<int>& lines)
{
    check_seen_from_above(surface, lines);
    const int n = static_cast<int>(surface.vertices.size());
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vector3d& v : surface.vertices)
        lowest = std::min(lowest, v.y());
    TriangleMesh solid = surface;
    for (const Vector3d& v : surface.vertices)
        solid.vertices.emplace_back(v.x(), lowest - depth, v.z());
    for (const auto& [a, b, c] : surface.triangles)
        solid.triangles.push_back({a + n, c + n, b + n});

    const std::vector<HalfEdge> edges = sorted_half_edges(surface);
    for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
        while (last < edges.size() && edges[last].same_edge(edges[first]))
            ++last;
        if (last - first > 1) continue;
        const HalfEdge& e = edges[first];
        const int from = e.is_upward ? e.low : e.high, to = e.is_upward ? e.high : e.low;
        solid.triangles.push_back({to, from, from + n});
        solid.triangles.push_back({to, from + n, to + n});
    }
    return solid;
}

} // namespace rigor
