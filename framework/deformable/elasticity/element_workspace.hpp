// SPDX-License-Identifier: MIT
// The elements of a solid with their strains and neighbors.
#pragma once

#include "deformable/elasticity/elements.hpp"

namespace rigor {

/// Data derived from a solid. Elastic and plastic strains change in each step; all other data stays
/// valid until the mesh or the material changes.
struct ElementWorkspace {
    explicit ElementWorkspace(const Deformable& solid);

    Elements elements;
    std::vector<ElementStrain> strains; // at the positions for which they were last computed
    std::vector<std::array<int, 4>> face_neighbours;
    // For each element, its neighbors across faces without a crack. For fracture, its stress is
    // averaged with their stresses.
    std::vector<std::vector<int>> stress_neighbours;
};

} // namespace rigor
