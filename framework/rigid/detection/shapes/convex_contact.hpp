// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends where two convex shapes (geometry/convex.hpp) are nearer than `reach`.
///
/// All touches have the normal along which the shapes are nearest, or part soonest. Where both turn
/// a face or a line to each other, one is clipped against the other (Sutherland and Hodgman 1974),
/// and each corner of what is left has the gap at its place; else there is one touch.
void find_convex_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                          const Pose& pose2, double reach, std::vector<Contact>& contacts);

} // namespace rigor
