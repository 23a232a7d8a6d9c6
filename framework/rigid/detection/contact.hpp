// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// Penetration slop: the overlap that the position correction leaves in piles, divided by the
/// radius of the contact (`ContactConstraint::radius`). With a much smaller slop a pile would never
/// come to rest, see `position_corrections` (position_correction.hpp). Where detection looks ahead
/// to the end of the step, shapes that overlap by less than this fraction of a length count as
/// separated. This length is the radius for a sphere and a box, the smallest half edge for two
/// boxes, and otherwise half the diagonal of the smaller shape's bounds.
inline constexpr double penetration_slop = 1e-4;

/// A contact: a pair of close points of two shapes, or of two bodies of a world. Its point lies in
/// the middle of the gap, except in these cases:
///
///   1. A shape and a plane (plane_contact.hpp): on the surface of the shape.
///   2. A sphere and a box (shape_contacts.cpp): on the surface of the sphere.
///   3. A sphere, a capsule or a torus that is tested by its core, the point or curve in its middle
///      (core_contact.hpp says which contacts these are): on the surface of this shape.
///   4. A contact that lies ahead (look_ahead.hpp): the point where it would be after the motion of
///      this step, moved back with the bodies.
struct Contact {
    Vector3d point = Vector3d::Zero();   // [m]
    Vector3d normal = Vector3d::UnitY(); // unit, from shape 2 to shape 1
    double gap = 0;                      // distance along the normal; negative if they overlap [m]
    int body1 = -1, body2 = -1;          // indices in the world; -1 for shapes without a body
};

} // namespace rigor
