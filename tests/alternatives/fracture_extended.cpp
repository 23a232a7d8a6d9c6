// SPDX-License-Identifier: MIT
// The heights of split_element in extended precision, which has more digits than a double. What is
// at a limit in doubles is then on one side of it.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace rigor {

namespace {

using Extended = Eigen::Matrix<long double, 3, 1>;
using Corners = std::array<int, 4>;

bool has(const Corners& tetrahedron, int vertex)
{
    return std::find(tetrahedron.begin(), tetrahedron.end(), vertex) != tetrahedron.end();
}

// The vertices of the tetrahedra that have the given vertex, with their heights above the plane,
// and the longest edge of these tetrahedra.
struct Star {
    std::map<int, long double> heights;
    long double longest = 0;

    Star(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
    {
        const auto from = [&](int a, int b) -> Extended {
            return mesh.vertices[b].cast<long double>() - mesh.vertices[a].cast<long double>();
        };
        for (const Corners& t : mesh.tetrahedra) {
            if (!has(t, vertex)) continue;
            for (const int a : t) {
                heights[a] = from(vertex, a).dot(normal.cast<long double>());
                for (const int b : t)
                    longest = std::max(longest, from(a, b).norm());
            }
        }
    }

    // The height that counts, 0 near the plane; that of a new vertex is 0 too.
    long double counted(int v) const
    {
        const auto found = heights.find(v);
        if (found == heights.end() || std::abs(found->second) < 0.05 * longest) return 0;
        return found->second;
    }

    bool any(bool (*is_there)(long double height)) const
    {
        return std::any_of(heights.begin(), heights.end(),
                           [&](const auto& entry) { return is_there(counted(entry.first)); });
    }
};

// A mesh during the cut, with the origins of its vertices and the parents of its tetrahedra.
struct Cutting {
    SplitMesh split;

    explicit Cutting(const TetrahedralMesh& mesh)
    {
        split.mesh = mesh;
        for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v)
            split.origins.push_back({v, v, 0});
        for (int t = 0; t < static_cast<int>(mesh.tetrahedra.size()); ++t)
            split.parents.push_back(t);
    }

    void halve(int a, int b, long double share)
    {
        std::vector<Vector3d>& x = split.mesh.vertices;
        const int middle = static_cast<int>(x.size());
        const Extended place =
            (1 - share) * x[a].cast<long double>() + share * x[b].cast<long double>();
        x.push_back(place.cast<double>());
        split.origins.push_back({a, b, static_cast<double>(share)});
        const std::size_t count = split.mesh.tetrahedra.size();
        for (std::size_t t = 0; t < count; ++t) {
            Corners &first = split.mesh.tetrahedra[t], second = first;
            if (!has(first, a) || !has(first, b)) continue;
            std::replace(first.begin(), first.end(), b, middle);
            std::replace(second.begin(), second.end(), a, middle);
            split.mesh.tetrahedra.push_back(second);
            split.parents.push_back(split.parents[t]);
        }
    }
};

// 1 for a tetrahedron above the plane, -1 for one below it.
int side_of(const Corners& tetrahedron, const Star& star)
{
    long double sum = 0;
    for (const int v : tetrahedron) {
        if (const long double h = star.counted(v); h != 0) return h > 0 ? 1 : -1;
        if (const auto found = star.heights.find(v); found != star.heights.end())
            sum += found->second;
    }
    return sum >= 0 ? 1 : -1;
}

} // namespace

SplitMesh split_element(const TetrahedralMesh& mesh, int vertex, const Vector3d& normal)
{
    Cutting cutting(mesh);
    const Star star(mesh, vertex, normal);
    if (!star.any([](long double h) { return h > 0; }) ||
        !star.any([](long double h) { return h < 0; }))
        return cutting.split;

    std::set<std::pair<int, int>> edges;
    for (const Corners& t : mesh.tetrahedra)
        if (has(t, vertex))
            for (const int a : t)
                for (const int b : t)
                    if (star.counted(a) > 0 && star.counted(b) < 0) edges.insert({a, b});
    for (const auto& [a, b] : edges)
        cutting.halve(a, b, star.counted(a) / (star.counted(a) - star.counted(b)));

    const SplitMesh& fine = cutting.split;
    std::map<std::set<int>, MeshFace> faces; // those of tetrahedra above, by their vertices
    std::vector<MeshFace> crack;
    const auto for_each_face = [&](int side, const auto& action) {
        for (int t = 0; t < static_cast<int>(fine.mesh.tetrahedra.size()); ++t) {
            const Corners& corners = fine.mesh.tetrahedra[t];
            if (!has(corners, vertex) || side_of(corners, star) != side) continue;
            for (int f = 0; f < 4; ++f) {
                std::set<int> vertices(corners.begin(), corners.end());
                vertices.erase(corners[f]);
                action(vertices, MeshFace{t, f});
            }
        }
    };
    for_each_face(1, [&](const auto& vertices, const MeshFace& face) { faces[vertices] = face; });
    for_each_face(-1, [&](const auto& vertices, const MeshFace&) {
        if (const auto found = faces.find(vertices); found != faces.end())
            crack.push_back(found->second);
    });
    SplitMesh result = split_along_faces(fine.mesh, crack);
    for (VertexOrigin& origin : result.origins)
        origin = fine.origins[origin.first];
    for (int& parent : result.parents)
        parent = fine.parents[parent];
    return result;
}

} // namespace rigor
