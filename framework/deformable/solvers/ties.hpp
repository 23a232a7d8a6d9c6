// SPDX-License-Identifier: MIT
// Constraints that prescribe the velocities of nodes in an implicit system, here called ties, and
// the rigid bodies that belong to the system.
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// A node whose velocity v is prescribed within a subspace: N v = N (c + V + ω × r). Here (V, ω) is
/// the motion of a rigid body that the system solves for, or zero without a body. In the other
/// directions the relative motion is damped by the impulse -d (δ - N) (v - c - V - ω × r), with the
/// unit matrix δ, so that friction dissipates energy for any d ≥ 0.
struct TiedNode {
    int node = 0;
    // Projector on the tied directions: all directions, the contact normal, or some axes.
    Matrix3d N = Matrix3d::Zero();
    Vector3d c = Vector3d::Zero(); // prescribed velocity relative to the body [m/s]
    int body = -1;                 // index of the body in the system, or -1 for none
    Vector3d r = Vector3d::Zero(); // from the center of the body to the node [m]
    double damping = 0;            // d [kg]
};

/// A rigid body that is part of the system.
struct SystemBody {
    /// The generalized mass: the momentum (P, L) of the body is this matrix times (V, ω) [kg, kg m,
    /// kg m²]. If the solid pushes the body against its supports, the mass is very large in the
    /// directions of these supports (contact/movers.hpp).
    Matrix6d mass = Matrix6d::Zero();
    // Velocity and angular velocity [m/s, rad/s]. A solve adds the effect of the body's contacts.
    Vector3d V = Vector3d::Zero(), w = Vector3d::Zero();
};

} // namespace rigor
