// SPDX-License-Identifier: MIT
// What ties nodes of an implicit system, and the rigid bodies that belong to it.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// A node whose velocity within a subspace is prescribed: N v = N (c + V + ω × r), with the motion
/// (V, ω) of a rigid body that the system solves for, or of none. What it does against that motion
/// in the rest of space is damped by the impulse -d (δ - N) (v - c - V - ω × r): so friction takes
/// energy, whatever d is.
struct TiedNode {
    int node = 0;
    Matrix3d N = Matrix3d::Zero(); // orthogonal projector: δ, n nᵀ, or axes
    Vector3d c = Vector3d::Zero(); // [m/s]
    int body = -1;                 // its number in the system; -1: none
    Vector3d r = Vector3d::Zero(); // from the center of the body [m]
    double damping = 0;            // d [kg]
};

/// A rigid body that is part of the system.
struct SystemBody {
    double mass = 0;
    Matrix3d inertia = Matrix3d::Zero(); // in world space
    Vector3d V = Vector3d::Zero(),
             w = Vector3d::Zero(); // before contacts; after a solve, with them
};

} // namespace rigor
