// SPDX-License-Identifier: MIT
// Finds the edges of a mesh: all half-edges are sorted by their vertices, so that the two
// half-edges of an edge become neighbors in the list.
#include "geometry/meshes/mesh_edges.hpp"

#include "geometry/meshes/triangle.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rigor {

std::vector<HalfEdge> sorted_half_edges(const TriangleMesh& mesh)
{
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const int from = mesh.triangles[t][i], to = mesh.triangles[t][(i + 1) % 3];
            edges.push_back(
                {std::min(from, to), std::max(from, to), from < to, static_cast<int>(t)});
        }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return edges;
}

std::vector<MeshEdge> mesh_edges(const TriangleMesh& mesh, const std::vector<Vector3d>& normals)
{
    const std::vector<HalfEdge> halves = sorted_half_edges(mesh);
    std::vector<MeshEdge> edges;
    edges.reserve(halves.size() / 2);
    for (std::size_t i = 0; i + 1 < halves.size(); i += 2) {
        const HalfEdge& up = halves[i].is_upward ? halves[i] : halves[i + 1];
        const HalfEdge& down = halves[i].is_upward ? halves[i + 1] : halves[i];
        const Vector3d along = (mesh.vertices[up.high] - mesh.vertices[up.low]).normalized();
        const double bend = normals[up.triangle].cross(normals[down.triangle]).dot(along);
        edges.push_back({up.low, up.high, up.triangle, down.triangle, bend});
    }
    return edges;
}

double facet_angle(const TriangleMesh& mesh)
{
    // The angle is between the normals of two faces. Below `flat` the faces lie in one plane, up to
    // rounding; above `largest` they meet at a real edge of the body and do not approximate a round
    // surface. A wheel with nine sides bends by 40 degrees at each edge, just below `largest`.
    constexpr double flat = 1e-6, largest = 0.7; // [rad]
    const std::vector<Vector3d> normals = triangle_normals(mesh);
    double angle = 0;
    for (const MeshEdge& edge : mesh_edges(mesh, normals)) {
        const double bend = std::atan2(edge.bend, normals[edge.left].dot(normals[edge.right]));
        if (bend > flat && bend < largest) angle = std::max(angle, bend);
    }
    return angle;
}

std::vector<Vector3d> triangle_normals(const TriangleMesh& mesh)
{
    std::vector<Vector3d> normals;
    normals.reserve(mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        normals.push_back(triangle_of(mesh, t).area_normal().normalized());
    return normals;
}

} // namespace rigor
