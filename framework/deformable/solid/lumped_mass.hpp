// SPDX-License-Identifier: MIT
#pragma once

#include "deformable/solid/deformable.hpp"

namespace rigor {

/// Volume of the matter in an element at rest: less than the element's where a virtual-node copy holds
/// but a part [m³].
double matter_volume(const Deformable& solid, int element);

/// Mass of each node: a quarter of that of each of its elements [kg].
std::vector<double> lumped_masses(const Deformable& solid);

} // namespace rigor
