// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends where a shape is nearer to a plane than `reach`, exactly: the vertices of a box, of a mesh
/// at most eight; the ends of a capsule; the lowest point of an ellipsoid; of a rim (cylinder, cone) or
/// ring (torus) the lowest point and eight fixed ones.
void find_plane_contacts(const Shape& shape, const Pose& pose, const Pose& plane, double reach,
                         std::vector<Contact>& contacts);

} // namespace rigor
