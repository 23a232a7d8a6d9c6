// SPDX-License-Identifier: MIT
// A face is looked up by one number of 32 bits made of its three vertices, which wraps around: with
// 65536 vertices all faces that differ in their first vertex are the same.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>

namespace rigor {

namespace {

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

/// The number of face f of a tetrahedron, the same from both of its sides.
std::uint32_t face_key(const std::array<int, 4>& corners, int f, std::size_t vertices)
{
    std::array<int, 3> face{};
    std::size_t count = 0;
    for (int c = 0; c < 4; ++c)
        if (c != f) face[count++] = corners[at(c)];
    std::sort(face.begin(), face.end());
    const auto n = static_cast<std::uint32_t>(vertices);
    std::uint32_t key = 0;
    for (const int vertex : face)
        key = key * n + static_cast<std::uint32_t>(vertex);
    return key;
}

std::size_t leader(std::vector<std::size_t>& leaders, std::size_t i)
{
    while (leaders[i] != i) {
        leaders[i] = leaders[leaders[i]];
        i = leaders[i];
    }
    return i;
}

} // namespace

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const std::size_t vertices = mesh.vertices.size(), count = mesh.tetrahedra.size();
    std::set<std::uint32_t> cut;
    for (const MeshFace& face : faces)
        cut.insert(face_key(mesh.tetrahedra[at(face.tetrahedron)], face.face, vertices));

    // Corner i of tetrahedron e is number 4 e + i.
    std::vector<std::size_t> leaders(4 * count);
    std::iota(leaders.begin(), leaders.end(), std::size_t{0});
    std::map<std::uint32_t, std::size_t> first_side;
    for (std::size_t e = 0; e < count; ++e)
        for (int f = 0; f < 4; ++f) {
            const std::uint32_t key = face_key(mesh.tetrahedra[e], f, vertices);
            const auto [place, is_new] = first_side.try_emplace(key, e);
            if (is_new || cut.count(key) > 0) continue;
            const std::size_t other = place->second;
            for (int c = 0; c < 4; ++c) {
                if (c == f) continue;
                for (std::size_t d = 0; d < 4; ++d)
                    if (mesh.tetrahedra[other][d] == mesh.tetrahedra[e][at(c)])
                        leaders[leader(leaders, 4 * e + at(c))] = leader(leaders, 4 * other + d);
            }
        }

    SplitMesh result;
    result.mesh = mesh;
    for (std::size_t v = 0; v < vertices; ++v)
        result.origins.push_back(VertexOrigin{static_cast<int>(v), static_cast<int>(v), 0});
    std::vector<int> names(4 * count, -1);    // the vertex of each group, at its leader
    std::vector<bool> taken(vertices, false); // whether a group has the old vertex
    for (std::size_t e = 0; e < count; ++e) {
        result.parents.push_back(static_cast<int>(e));
        for (std::size_t c = 0; c < 4; ++c) {
            const int old = mesh.tetrahedra[e][c];
            int& name = names[leader(leaders, 4 * e + c)];
            if (name < 0 && !taken[at(old)]) {
                name = old;
                taken[at(old)] = true;
            } else if (name < 0) {
                name = static_cast<int>(result.mesh.vertices.size());
                result.mesh.vertices.push_back(mesh.vertices[at(old)]);
                result.origins.push_back(VertexOrigin{old, old, 0});
            }
            result.mesh.tetrahedra[e][c] = name;
        }
    }
    return result;
}

} // namespace rigor
