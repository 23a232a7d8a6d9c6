// SPDX-License-Identifier: MIT
// A rigid body: its shape, its mass and its state.
#pragma once

#include "formulas/types.hpp"
#include "geometry/shapes/shape.hpp"
#include "rigid/bodies/drive.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

struct Material {
    double restitution = 0.5; // ε, 0 … 1
    double friction = 0.5;    // μ ≥ 0
};

/// The material of a contact between two bodies: the smaller of their restitutions, and the
/// geometric mean of their frictions.
inline Material combined(const Material& a, const Material& b)
{
    return {std::min(a.restitution, b.restitution), std::sqrt(a.friction * b.friction)};
}

/// The resistance of a medium: the force -(c + k |V|) V on the center of mass, and the torque -d ω.
struct Drag {
    double linear = 0;    // c ≥ 0 [kg/s]
    double quadratic = 0; // k ≥ 0 [kg/m]
    double turning = 0;   // d ≥ 0 [N m s]

    bool acts() const { return linear != 0 || quadratic != 0 || turning != 0; }
};

/// The time for which a body has been at rest, and whether the body sleeps.
struct Rest {
    double duration = 0; // time for which the body has stayed near `place`, see step/sleep [s]
    RigidState place;    // later states of the body are compared with this one
    int group = -1; // id of the group of bodies that fell asleep together; -1: the body is awake

    bool is_asleep() const { return group >= 0; }
};

/// A rigid body. Its object space has the axes in which the scene file describes the body. The
/// origin of object space is the center of mass or, for a static body, the origin of the scene
/// file's description.
struct RigidBody {
    std::string name;
    std::vector<Part> parts; // in object space
    Material material;
    Drag drag;
    int group = 0; // bodies of the same group pass through each other; 0: no group
    bool is_static = false;
    std::shared_ptr<const Drive> drive;  // prescribed motion of a static body; null: none
    double mass = 0;                     // [kg]; 0 if static
    Matrix3d inertia = Matrix3d::Zero(); // I_body, about the center of mass [kg m²]
    BodyInertia inverse;                 // 1/M and I_body⁻¹, computed once; zero if static
    // The principal axes Q as columns and the inverse moments along them, I_body⁻¹ = Q diag(J) Qᵀ.
    // A body with `only_axis` does not use them: `let_turn_about` (mass.hpp) sets its I_body⁻¹.
    Matrix3d principal_axes = Matrix3d::Identity();
    Vector3d inverse_moments = Vector3d::Zero(); // J [1/(kg m²)]
    // Whether I_body = i δ (i: a number, δ: identity), so that I(t)⁻¹ = I_body⁻¹ in every
    // orientation. False for a static body and for a body with `only_axis`.
    bool is_isotropic = false;
    // Symmetry axis a of a body of revolution, or of a body whose inertia has the same form, such
    // as a box with a square base: a unit vector in object space with I_body⁻¹ = i δ + k a aᵀ
    // for two numbers i and k. Zero if the body has no such axis or is isotropic.
    Vector3d symmetry_axis = Vector3d::Zero();
    // The only axis about which the body turns: a unit vector in object space, or zero if the body
    // never turns. Without a value the body turns freely.
    std::optional<Vector3d> only_axis;
    RigidState state;
    Rest rest;

    /// Whether the body is a ball, which occupies the same space in every orientation: its only
    /// part is a sphere about the center of mass.
    bool is_ball() const
    {
        return parts.size() == 1 && std::holds_alternative<Sphere>(parts[0].shape) &&
               parts[0].position.isZero(0);
    }

    bool is_body_of_revolution() const { return !symmetry_axis.isZero(0); }

    /// Whether the pose of the body stays the same in this step: the body sleeps, or it is static
    /// and either has no drive or is a belt. A belt moves only the bodies that touch its surface.
    bool is_still() const { return (is_static && !changes_place()) || rest.is_asleep(); }

    /// Whether the body has a drive other than a belt, so that the drive moves or turns the body
    /// itself. The result is the same at all times, also before the drive starts and after it ends.
    bool changes_place() const { return drive && !drive->is_belt; }
};

} // namespace rigor
