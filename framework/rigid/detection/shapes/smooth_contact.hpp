// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"
#include "rigid/detection/shapes/distance_field.hpp"

namespace rigor {

/// Smallest cosine of the angle between a contact normal and the gradient of the other shape's
/// distance; the largest angle is 73°. At a larger angle, a point belongs to the far side of the
/// shape or of a thin wall. The angle was chosen by trial.
inline constexpr double least_opposition = 0.3;

/// Appends the contacts where the surface of a convex shape is closer than `reach` to the shape to
/// which a distance field belongs.
///
/// The iteration starts from points spread over the surface. Each step takes the field's gradient
/// at the current point and goes to the point of the surface that lies farthest in the opposite
/// direction. If a whole face or line lies there, the step goes to its corner nearest to the
/// field's shape. The iteration ends when the direction of the gradient no longer changes, or after
/// four steps. The points where it ends are local minima of the field on the surface.
///
/// @param shape  a box, a cylinder, a cone or an ellipsoid
/// @param pose   pose of the shape in the frame of the field; the contacts are in this frame too,
///               with normals out of the field's shape
/// @return       the deepest of all tested points, whether it is a contact or not
DeepestPoint find_smooth_contacts(const Shape& shape, const Pose& pose, const DistanceField& field,
                                  double reach, std::vector<Contact>& contacts);

} // namespace rigor
