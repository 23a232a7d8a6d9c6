// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/bodies/counters.hpp"
#include "rigid/detection/contact.hpp"

namespace rigor {

/// Appends the contacts of a sphere, a capsule or a torus with another shape, if they are closer
/// than `reach`.
///
/// Shape 1 is a core (a point, a segment, a circle) with a radius around it. The following contacts
/// are found, if their gap is below `reach`. If there are many, they are reduced to a few
/// (reduce_contacts.hpp).
///
///   * A sphere: where the other shape is nearest. With a mesh, at each local minimum of the
///     distance, if the center is outside the mesh. With a torus, at three points of the torus,
///     one of them the nearest.
///   * A capsule: at the ends of its segment, at local minima of the gap, and at the ends of the
///     parts along which the gap changes linearly, as above a flat face.
///   * A torus: at four or eight points spread evenly around its circle, and at other local minima.
///   * A capsule or a torus with a mesh that is not convex: also at points of the mesh, so that a
///     peg in a hole has contacts on all sides.
///
/// A contact lies on the surface of shape 1, and its normal passes through the core. There are two
/// exceptions. The contacts of a sphere with a torus lie in the middle of the gap. Contacts at
/// points of a mesh lie in the middle of the gap too, and their normal is a normal of the mesh
/// (mesh_contact.hpp).
///
/// @param shape1  a sphere, a capsule or a torus
/// @param shape2  anything but a plane
void find_core_contacts(const Shape& shape1, const Pose& pose1, const Shape& shape2,
                        const Pose& pose2, double reach, Counters& counters,
                        std::vector<Contact>& contacts);

} // namespace rigor
