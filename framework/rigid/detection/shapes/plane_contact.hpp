// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of a shape with a plane, computed in closed form. The following points are
/// contacts if they are closer to the plane than `reach`: the vertices of a box, at most eight
/// vertices of a mesh, the lowest point of each end of a capsule, the lowest point of a sphere or
/// an ellipsoid, and the tip of a cone. The rim of a cylinder or a cone, and a torus, have eight
/// fixed points if they are parallel to the plane. Otherwise they have the lowest point and the
/// three points at quarters of a turn from it. "Lowest" means nearest to the plane or deepest below
/// it.
void find_plane_contacts(const Shape& shape, const Pose& pose, const Pose& plane, double reach,
                         std::vector<Contact>& contacts);

} // namespace rigor
