// SPDX-License-Identifier: MIT
// Correct cutting of tetrahedral meshes along faces (A7.5): faces, and corners that are joined.
#pragma once

#include "formulas/fracture.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace rigor::cutting {

using Tetrahedron = std::array<int, 4>;
using Face = std::array<int, 3>;

inline Face face_of(const Tetrahedron& t, int f)
{
    Face face = {t[(f + 1) % 4], t[(f + 2) % 4], t[(f + 3) % 4]};
    std::sort(face.begin(), face.end());
    return face;
}

inline int corner_of(const Tetrahedron& t, int vertex)
{
    return static_cast<int>(std::find(t.begin(), t.end(), vertex) - t.begin());
}

inline std::map<Face, std::vector<int>> faces_of(const TetrahedralMesh& mesh)
{
    std::map<Face, std::vector<int>> faces;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        for (int f = 0; f < 4; ++f)
            faces[face_of(mesh.tetrahedra[t], f)].push_back(static_cast<int>(t));
    return faces;
}

/// The corners of all tetrahedra, as a union-find structure: joined corners are one vertex.
class Corners {
public:
    explicit Corners(std::size_t tetrahedra) : above_(4 * tetrahedra)
    {
        std::iota(above_.begin(), above_.end(), 0);
    }
    int find(int i)
    {
        while (above_[i] != i)
            i = above_[i] = above_[above_[i]];
        return i;
    }
    void join(int t1, int c1, int t2, int c2) { above_[find(4 * t1 + c1)] = find(4 * t2 + c2); }

private:
    std::vector<int> above_;
};

/// Renumbers the vertices, one for each set of joined corners.
/// @return the vertex of the original mesh that each one comes from
inline std::vector<int> number_vertices(std::vector<Tetrahedron>& tetrahedra, Corners& corners)
{
    std::map<int, int> number;
    std::vector<int> parents;
    for (std::size_t t = 0; t < tetrahedra.size(); ++t)
        for (int c = 0; c < 4; ++c) {
            const int next = static_cast<int>(parents.size());
            const auto [entry, is_new] =
                number.emplace(corners.find(4 * static_cast<int>(t) + c), next);
            if (is_new) parents.push_back(tetrahedra[t][c]);
            tetrahedra[t][c] = entry->second;
        }
    return parents;
}

/// The vertices that no tetrahedron uses.
inline std::vector<int> unused_vertices(const TetrahedralMesh& mesh)
{
    std::vector<bool> is_used(mesh.vertices.size());
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int v : t)
            is_used[v] = true;
    std::vector<int> unused;
    for (std::size_t v = 0; v < is_used.size(); ++v)
        if (!is_used[v]) unused.push_back(static_cast<int>(v));
    return unused;
}

/// The mesh in which exactly these corners are joined. Without `keeps_unused`, vertices that no
/// tetrahedron uses are left out, which is a mistake.
inline SplitMesh with_joined(const TetrahedralMesh& mesh, Corners& corners,
                             bool keeps_unused = true)
{
    SplitMesh result = {{{}, mesh.tetrahedra}, {}, std::vector<int>(mesh.tetrahedra.size())};
    std::iota(result.parents.begin(), result.parents.end(), 0);
    std::vector<int> parents = number_vertices(result.mesh.tetrahedra, corners);
    if (keeps_unused)
        for (int v : unused_vertices(mesh))
            parents.push_back(v);
    for (int parent : parents) {
        result.mesh.vertices.push_back(mesh.vertices[parent]);
        result.origins.push_back({parent, parent, 0});
    }
    return result;
}

/// The mesh split along the faces for which `is_cut(face)` is true (A7.5).
template <class IsCut>
SplitMesh split_where(const TetrahedralMesh& mesh, IsCut is_cut, bool keeps_unused = true)
{
    Corners corners(mesh.tetrahedra.size());
    for (const auto& [face, sharing] : faces_of(mesh))
        if (sharing.size() == 2 && !is_cut(face))
            for (int v : face)
                corners.join(sharing[0], corner_of(mesh.tetrahedra[sharing[0]], v), sharing[1],
                             corner_of(mesh.tetrahedra[sharing[1]], v));
    return with_joined(mesh, corners, keeps_unused);
}

} // namespace rigor::cutting
