// SPDX-License-Identifier: MIT
// An edge of less than a hundred-thousandth of the longest one counts as 0.
#include "mistakes/inertia/bounding_box.hpp"

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    const Bounds box = bounds_of(vertices);
    Vector3d edges = box.edges();
    for (double& edge : edges)
        if (edge < 1e-5 * box.edges().maxCoeff()) edge = 0;
    return box_of(mass, box.center(), edges);
}

} // namespace rigor
