// SPDX-License-Identifier: MIT
// The volume of the box is taken for its mass.
#include "mistakes/inertia/bounding_box.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    const Bounds box = bounds_of(vertices);
    return box_of(box.edges().prod(), box.center(), box.edges());
}

} // namespace rigor
