// SPDX-License-Identifier: MIT
// Prepares the elements of a solid and finds the neighbors with which each shares a face. The
// stress of an element is smoothed only with neighbors from which no crack separates it.
#include "deformable/elasticity/element_workspace.hpp"

#include "geometry/tetrahedra/tetrahedra.hpp"

namespace rigor {

namespace {

std::vector<std::vector<int>>
uncracked_neighbours(const Deformable& solid, const std::vector<std::array<int, 4>>& neighbours)
{
    std::vector<std::vector<int>> lists(neighbours.size());
    const bool has_cracks = !solid.crack_faces.empty() && solid.embedded.parents.empty();
    for (std::size_t t = 0; t < neighbours.size(); ++t)
        for (int f = 0; f < 4; ++f)
            if (neighbours[t][f] >= 0 && !(has_cracks && solid.crack_faces[t][f]))
                lists[t].push_back(neighbours[t][f]);
    return lists;
}

} // namespace

ElementWorkspace::ElementWorkspace(const Deformable& solid)
    : elements(solid), face_neighbours(rigor::face_neighbours(solid.rest)),
      stress_neighbours(uncracked_neighbours(solid, face_neighbours))
{
}

} // namespace rigor
