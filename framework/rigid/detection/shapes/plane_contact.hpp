// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of a shape with a plane, exactly. They are those of the following points
/// that are closer to the plane than `reach`: the vertices of a box, at most eight vertices of a
/// mesh, the lowest point of each end of a capsule, the lowest point of a sphere or an ellipsoid,
/// and the tip of a cone. For a rim (cylinder, cone) or a ring (torus) they are eight fixed points
/// if it is parallel to the plane, otherwise the lowest point and the three at quarters of a turn
/// from it.
void find_plane_contacts(const Shape& shape, const Pose& pose, const Pose& plane, double reach,
                         std::vector<Contact>& contacts);

} // namespace rigor
