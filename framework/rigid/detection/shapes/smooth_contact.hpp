// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"
#include "rigid/detection/shapes/distance_field.hpp"

namespace rigor {

/// Least cosine between a contact normal and the gradient of the other shape's distance, 73°. Below
/// it, a point belongs to the far side of the shape or of a thin wall. Chosen by trial.
inline constexpr double least_opposition = 0.3;

/// Appends the contacts where the surface of a convex shape is closer than `reach` to the shape of
/// a distance field.
///
/// The iteration starts from points spread over the surface. Each step goes to the point of the
/// surface (or the ends of the face or line) that lies farthest against the field's gradient, until
/// the direction of the gradient no longer changes. The points where it ends are local minima of
/// the field on the surface.
///
/// @param shape  a box, a cylinder, a cone or an ellipsoid
/// @param pose   pose of the shape in the frame of the field; the contacts are in this frame too,
///               with normals out of the field's shape
/// @return       the deepest point that was looked at, whether it is a contact or not
DeepestPoint find_smooth_contacts(const Shape& shape, const Pose& pose, const DistanceField& field,
                                  double reach, std::vector<Contact>& contacts);

} // namespace rigor
