// SPDX-License-Identifier: MIT
// What the sources of topic `fracture` share: tetrahedra as corner indices, and whether a mesh
// refers only to vertices that it has.
#pragma once

#include "formulas/fracture.hpp"

#include <algorithm>

namespace rigor {

using Tetrahedron = std::array<int, 4>;
using Tetrahedra = std::vector<Tetrahedron>;

inline bool is_index(int i, std::size_t size)
{
    return i >= 0 && static_cast<std::size_t>(i) < size;
}

inline bool is_mesh(const TetrahedralMesh& mesh)
{
    for (const Tetrahedron& t : mesh.tetrahedra)
        for (int v : t)
            if (!is_index(v, mesh.vertices.size())) return false;
    return true;
}

/// The corner of the tetrahedron that is this vertex; 4 if none is.
inline int corner_of(const Tetrahedron& t, int vertex)
{
    return static_cast<int>(std::find(t.begin(), t.end(), vertex) - t.begin());
}

} // namespace rigor
