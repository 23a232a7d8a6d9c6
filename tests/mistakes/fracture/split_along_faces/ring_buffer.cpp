// SPDX-License-Identifier: MIT
// At most 64 tetrahedra can wait in the search around a vertex; there may be more.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <map>

namespace rigor {

namespace {

/// The corners of each face.
constexpr int corners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// For each side 4 e + f the side of the other tetrahedron that has this face, or -1.
std::vector<int> other_sides(const std::vector<std::array<int, 4>>& tetrahedra)
{
    std::vector<int> other(4 * tetrahedra.size(), -1);
    std::map<std::array<int, 3>, int> seen;
    for (int e = 0; e < static_cast<int>(tetrahedra.size()); ++e)
        for (int f = 0; f < 4; ++f) {
            std::array<int, 3> key;
            for (int i = 0; i < 3; ++i)
                key[i] = tetrahedra[e][corners[f][i]];
            std::sort(key.begin(), key.end());
            const auto [at, is_new] = seen.emplace(key, 4 * e + f);
            if (is_new) continue;
            other[4 * e + f] = at->second;
            other[at->second] = 4 * e + f;
        }
    return other;
}

} // namespace

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    SplitMesh split;
    split.mesh = mesh;
    const auto& tetrahedra = mesh.tetrahedra;
    const int count = static_cast<int>(tetrahedra.size());
    const int vertices = static_cast<int>(mesh.vertices.size());
    for (int v = 0; v < vertices; ++v)
        split.origins.push_back({v, v, 0});
    for (int e = 0; e < count; ++e)
        split.parents.push_back(e);

    std::vector<int> other = other_sides(tetrahedra);
    for (const MeshFace& face : faces) {
        const int side = 4 * face.tetrahedron + face.face;
        if (other[side] < 0) continue;
        other[other[side]] = -1;
        other[side] = -1;
    }
    std::vector<std::vector<int>> around(mesh.vertices.size()); // corners 4 e + i
    for (int c = 0; c < 4 * count; ++c)
        around[tetrahedra[c / 4][c % 4]].push_back(c);

    std::vector<int> visited(tetrahedra.size(), -1); // the last vertex around which it was found
    std::array<int, 16> queue{};                     // only the front of the search waits here
    for (int v = 0; v < vertices; ++v) {
        bool first = true;
        for (const int start : around[v]) {
            if (visited[start / 4] == v) continue;
            int vertex = v;
            if (!first) {
                vertex = static_cast<int>(split.mesh.vertices.size());
                split.mesh.vertices.push_back(mesh.vertices[v]);
                split.origins.push_back({v, v, 0});
            }
            first = false;
            std::size_t head = 0, tail = 0;
            queue[tail++] = start / 4;
            while (head < tail) {
                const int e = queue[head++ % queue.size()];
                if (visited[e] == v) continue;
                visited[e] = v;
                for (int i = 0; i < 4; ++i) {
                    if (tetrahedra[e][i] == v) {
                        split.mesh.tetrahedra[e][i] = vertex;
                        continue; // the face opposite v does not have it
                    }
                    const int side = other[4 * e + i];
                    if (side >= 0 && visited[side / 4] != v)
                        queue[tail++ % queue.size()] = side / 4;
                }
            }
        }
    }
    return split;
}

} // namespace rigor
