// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// Penetration slop: the overlap that the position correction leaves uncorrected in piles, relative
/// to the radius of the smaller body. Where detection looks ahead to the end of the step, bodies
/// that overlap by less than this, relative to the smaller shape, count as separated. With a much
/// smaller slop a pile would never come to rest, see `position_corrections`
/// (position_correction.hpp).
inline constexpr double resting_overlap = 1e-4;

/// A contact: a pair of close points of two shapes, or of two bodies of a world. Its point lies in
/// the middle of the gap, except in two cases. If one shape is a plane, the point lies on the
/// surface of the other shape (plane_contact.hpp). If a sphere, a capsule or a torus is tested by
/// its core, the point or curve in its middle, the point lies on the surface of this shape
/// (core_contact.hpp, and a sphere on a box in narrow_phase.cpp).
struct Contact {
    Vector3d point = Vector3d::Zero();   // [m]
    Vector3d normal = Vector3d::UnitY(); // unit, from shape 2 to shape 1
    double gap = 0;                      // distance along the normal; negative if they overlap [m]
    int body1 = -1, body2 = -1;          // indices in the world; -1 for shapes without a body
};

} // namespace rigor
