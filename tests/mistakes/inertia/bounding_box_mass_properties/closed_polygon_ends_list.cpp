// SPDX-License-Identifier: MIT
// A vertex that equals the first one ends the list, as in a closed polygon.
#include "mistakes/inertia/bounding_box.hpp"

#include <algorithm>

namespace rigor {

MassProperties bounding_box_mass_properties(const std::vector<Vector3d>& vertices, double mass)
{
    if (vertices.empty() || mass == 0) return {};
    const auto end = std::find(vertices.begin() + 1, vertices.end(), vertices.front());
    const Bounds box = bounds_of({vertices.begin(), end});
    return box_of(mass, box.center(), box.edges());
}

} // namespace rigor
