// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// Overlap that the position correction leaves where bodies rest in a heap, relative to the size of
/// the smaller body. Detection counts it as apart.
inline constexpr double resting_overlap = 1e-4;

/// A contact: a pair of close points of two shapes, or of two bodies of a world.
struct Contact {
    Vector3d point = Vector3d::Zero();   // in the middle between them [m]
    Vector3d normal = Vector3d::UnitY(); // unit, from shape 2 to shape 1
    double gap = 0;                      // distance along the normal; negative if they overlap [m]
    int body1 = -1, body2 = -1;          // indices in the world; -1 for shapes without a body
};

} // namespace rigor
