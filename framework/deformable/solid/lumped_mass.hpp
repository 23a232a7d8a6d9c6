// SPDX-License-Identifier: MIT
// Mass of a solid, lumped at its nodes.
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// Volume of the material in an element at rest [m³]. In a copy made for virtual nodes, material
/// fills only a part of the element.
double matter_volume(const Deformable& solid, int element);

/// Mass of each node [kg]: a quarter of the mass of each element at the node, added up.
std::vector<double> lumped_masses(const Deformable& solid);

} // namespace rigor
