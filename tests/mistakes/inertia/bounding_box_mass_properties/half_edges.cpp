// SPDX-License-Identifier: MIT
// Half edges are used as if they were full ones.
#include "mistakes/inertia/bounding_box.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    const Bounds box = bounds_of(vertices);
    return box_of(mass, box.center(), box.edges() / 2);
}

} // namespace rigor
