// SPDX-License-Identifier: MIT
// The center of the box is the origin only by chance.
#include "mistakes/inertia/bounding_box.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    return box_of(mass, Vector3d::Zero(), bounds_of(vertices).edges());
}

} // namespace rigor
