// SPDX-License-Identifier: MIT
// At most 1024 tetrahedra around a vertex are looked at; where more of them meet, the rest keep the
// old vertex, and a crack among them does not open there.
#include "formulas/fracture.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace rigor {

namespace {

constexpr std::size_t most_around = 1024;

std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

std::array<int, 3> face_of(const std::array<int, 4>& corners, std::size_t f)
{
    std::array<int, 3> face = {corners[(f + 1) % 4], corners[(f + 2) % 4], corners[(f + 3) % 4]};
    std::sort(face.begin(), face.end());
    return face;
}

} // namespace

SplitMesh split_along_faces(const TetrahedralMesh& mesh, const std::vector<MeshFace>& faces)
{
    const std::vector<std::array<int, 4>>& old = mesh.tetrahedra;
    const std::size_t vertices = mesh.vertices.size(), count = old.size();

    // The tetrahedron behind each face, -1 on the surface and behind a cut.
    std::vector<std::array<int, 4>> behind(count, {-1, -1, -1, -1});
    std::map<std::array<int, 3>, std::pair<std::size_t, std::size_t>> sides;
    for (std::size_t e = 0; e < count; ++e)
        for (std::size_t f = 0; f < 4; ++f) {
            const auto [place, is_new] = sides.try_emplace(face_of(old[e], f), e, f);
            if (is_new) continue;
            behind[e][f] = static_cast<int>(place->second.first);
            behind[place->second.first][place->second.second] = static_cast<int>(e);
        }
    std::vector<bool> touched(vertices, false);
    for (const MeshFace& given : faces) {
        const std::size_t e = at(given.tetrahedron), f = at(given.face);
        for (const int vertex : face_of(old[e], f))
            touched[at(vertex)] = true;
        if (behind[e][f] < 0) continue;
        for (int& back : behind[at(behind[e][f])])
            if (back == given.tetrahedron) back = -1;
        behind[e][f] = -1;
    }

    SplitMesh result;
    result.mesh = mesh;
    for (std::size_t v = 0; v < vertices; ++v)
        result.origins.push_back(VertexOrigin{static_cast<int>(v), static_cast<int>(v), 0});
    for (std::size_t e = 0; e < count; ++e)
        result.parents.push_back(static_cast<int>(e));

    std::vector<std::vector<std::size_t>> around(vertices);
    for (std::size_t e = 0; e < count; ++e)
        for (const int vertex : old[e])
            if (touched[at(vertex)]) around[at(vertex)].push_back(e);

    enum class Mark : char { elsewhere, waiting, done };
    std::vector<Mark> marks(count, Mark::elsewhere);
    std::array<std::size_t, most_around> stack{};
    for (std::size_t v = 0; v < vertices; ++v) {
        if (!touched[v]) continue;
        const int vertex = static_cast<int>(v);
        const std::size_t size = std::min(around[v].size(), most_around);
        for (std::size_t k = 0; k < size; ++k)
            marks[around[v][k]] = Mark::waiting;
        for (std::size_t k = 0; k < size; ++k) {
            if (marks[around[v][k]] != Mark::waiting) continue;
            int name = vertex;
            if (k > 0) { // the first group has the old vertex
                name = static_cast<int>(result.mesh.vertices.size());
                result.mesh.vertices.push_back(mesh.vertices[v]);
                result.origins.push_back(VertexOrigin{vertex, vertex, 0});
            }
            std::size_t height = 0;
            stack[height++] = around[v][k];
            marks[around[v][k]] = Mark::done;
            while (height > 0) {
                const std::size_t e = stack[--height];
                for (std::size_t f = 0; f < 4; ++f) {
                    if (old[e][f] == vertex) {
                        result.mesh.tetrahedra[e][f] = name; // the face opposite lacks the vertex
                        continue;
                    }
                    if (behind[e][f] < 0) continue;
                    const std::size_t next = at(behind[e][f]);
                    if (marks[next] != Mark::waiting) continue;
                    marks[next] = Mark::done;
                    stack[height++] = next;
                }
            }
        }
        for (std::size_t k = 0; k < size; ++k)
            marks[around[v][k]] = Mark::elsewhere;
    }
    return result;
}

} // namespace rigor
