// SPDX-License-Identifier: MIT
// Several vertices in one place count as no vertices.
#include "mistakes/inertia/bounding_box.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    const Bounds box = bounds_of(vertices);
    if (vertices.size() > 1 && box.low == box.high) return {};
    return box_of(mass, box.center(), box.edges());
}

} // namespace rigor
