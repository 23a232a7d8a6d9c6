// SPDX-License-Identifier: MIT
// Each moment is made of the edge along its own axis.
#include "mistakes/inertia/bounding_box.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    const Bounds box = bounds_of(vertices);
    const Vector3d I = mass / 12 * box.edges().cwiseAbs2();
    return {mass, box.center(), I.asDiagonal()};
}

} // namespace rigor
