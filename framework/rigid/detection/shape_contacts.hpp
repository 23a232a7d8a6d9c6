// SPDX-License-Identifier: MIT
// The contacts of two shapes.
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/detection/contact.hpp"

#include <vector>

namespace rigor {

/// Appends the contacts of two shapes that are closer than `reach`.
///
/// A sphere has one contact with another shape, but it may have several with a torus or a mesh.
/// Each normal passes through the center of the sphere, so an impulse without friction has no
/// torque about this center.
///
/// The methods for other shapes are in plane_contact.hpp, core_contact.hpp (capsules and tori),
/// box_box.hpp, convex_contact.hpp (all other pairs of convex shapes) and mesh_contact.hpp (a mesh
/// that is not convex). Two planes never touch.
///
/// Two capsules are sampled like any capsule (core_contact.hpp), although their distance has a
/// closed form.
void find_shape_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                         const Pose& pose2, double reach, std::vector<Contact>& contacts);

/// Does the same as the other `find_shape_contacts`, and looks ahead.
/// @param move      displacement of shape 1 relative to shape 2 in this step [m], for two boxes, or
///                  a sphere and a box; with 0, the search does not look ahead
/// @param counters  increased by the numbers of built level sets and of their samples
void find_shape_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                         const Pose& pose2, const Vector3d& move, double reach, Counters& counters,
                         std::vector<Contact>& contacts);

/// Whether a shape is a point, a segment or a circle with a radius around it (core_contact.hpp).
bool has_core(const Shape& shape);

} // namespace rigor
