// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/elasticity/elements.hpp"

namespace rigor {

struct ElementWorkspace {
    explicit ElementWorkspace(const Deformable& solid);

    Elements elements;
    std::vector<ElementStrain> strains;
    std::vector<std::array<int, 4>> face_neighbours;
    std::vector<std::vector<int>>
        stress_neighbours; // of each element, across faces that no crack runs along
};

} // namespace rigor
