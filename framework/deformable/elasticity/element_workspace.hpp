// SPDX-License-Identifier: MIT
// The elements of a solid with their strains and neighbours.
#pragma once

#include "deformable/elasticity/elements.hpp"

namespace rigor {

/// Data derived from a solid. It is valid as long as the mesh and the material stay the same.
struct ElementWorkspace {
    explicit ElementWorkspace(const Deformable& solid);

    Elements elements;
    std::vector<ElementStrain> strains;
    std::vector<std::array<int, 4>> face_neighbours;
    // For each element, its neighbours across faces without a crack. Its stress is averaged with
    // their stresses.
    std::vector<std::vector<int>> stress_neighbours;
};

} // namespace rigor
