// SPDX-License-Identifier: MIT
// A rigid body: its shape, its mass and its state.
#pragma once

#include "formulas/types.hpp"
#include "geometry/shapes/shape.hpp"

#include <string>
#include <vector>

namespace rigor {

struct Material {
    double restitution = 0.5; // ε, 0 … 1; two bodies in contact use the smaller of their values
    double friction = 0.5; // μ ≥ 0; two bodies in contact use the geometric mean of their values
};

/// How long a body has been at rest, and whether it sleeps.
struct Rest {
    double duration = 0; // time since the body came to `place` [s]
    RigidState place;
    int group = -1; // number of the group that fell asleep together; -1 while the body is awake

    bool is_asleep() const { return group >= 0; }
};

/// A rigid body. Object space has its origin at the center of mass and the axes of the scene file.
struct RigidBody {
    std::string name;
    std::vector<Part> parts; // in object space
    Material material;
    bool is_static = false;
    double mass = 0;                     // [kg]; 0 if static
    Matrix3d inertia = Matrix3d::Zero(); // I_body, about the center of mass [kg m²]
    BodyInertia inverse;       // computed once, through the principal axes; zero if static
    bool is_isotropic = false; // whether I_body = i δ, and so I(t)⁻¹ = I_body⁻¹
    // Symmetry axis a of a body of revolution: a unit vector in object space with I_body⁻¹ = i δ +
    // k a aᵀ. Zero if the body has no such axis.
    Vector3d symmetry_axis = Vector3d::Zero();
    RigidState state;
    Rest rest;

    bool is_symmetric() const { return !symmetry_axis.isZero(0); }

    /// Whether the body is static or asleep, so that nothing moves it in this step.
    bool is_still() const { return is_static || rest.is_asleep(); }
};

} // namespace rigor
