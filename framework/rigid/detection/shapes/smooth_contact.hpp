// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"
#include "rigid/detection/shapes/distance_field.hpp"

namespace rigor {

/// Appends where the surface of a convex shape is nearer than `reach` to what a distance field is of.
///
/// From points spread over the surface, each step goes to the point (or the ends of the face or line)
/// that looks against the field's gradient, until it looks so: the places where the field is locally
/// least on the surface.
///
/// @param shape  a box, a cylinder, a cone or an ellipsoid
/// @param pose   of the shape in the frame of the field, as are the touches; normals out of the field
void find_smooth_contacts(const Shape& shape, const Pose& pose, const DistanceField& field,
                          double reach, std::vector<Contact>& contacts);

} // namespace rigor
