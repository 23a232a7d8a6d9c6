// SPDX-License-Identifier: MIT
// One step under a constant wrench. A body of revolution without torque takes two exact rotations.
// Any other body takes one rotation by Ω h, where Ω is the constant angular velocity that gives the
// same rotation as the changing ω. Ω comes from a series of ω and its derivatives, by Buss's
// augmented fourth-order method (2000); for a body without torque it can also be exact.
#include "rigid/motion/constant_wrench_step.hpp"

#include "formulas/rotation.hpp"
#include "rigid/bodies/orientation.hpp"
#include "rigid/motion/free_rotation.hpp"

namespace rigor {

namespace {

// The mean angular velocity Ω: the constant angular velocity that gives the same rotation over the
// step as the changing ω.
Vector3d mean_angular_velocity(const Matrix3d& J, const Vector3d& L, const Vector3d& torque,
                               double h)
{
    const Vector3d w = J * L;
    const auto J_dot = [&J](const Vector3d& spin, const Vector3d& x) -> Vector3d {
        return spin.cross(J * x) - J * spin.cross(x);
    };
    // ω̇ = -J a  with  a = ω × L - τ.  The derivatives of a and of ω̇ follow from this by L̇ = τ.
    const Vector3d a = w.cross(L) - torque;
    const Vector3d w1 = -J * a;
    const Vector3d a1 = w1.cross(L) + w.cross(torque);
    const Vector3d w2 = -J_dot(w, a) - J * a1;
    const Vector3d a2 = w2.cross(L) + 2 * w1.cross(torque);
    // J̈ = ω̇* J - J ω̇* + ω* J̇ - J̇ ω*, where ω* is the matrix with ω* x = ω × x
    const Vector3d J_ddot_a = J_dot(w1, a) + w.cross(J_dot(w, a)) - J_dot(w, w.cross(a));
    const Vector3d w3 = -J_ddot_a - 2 * J_dot(w, a1) - J * a2;

    return w + h / 2 * w1 + h * h / 6 * w2 + h * h * h / 24 * w3 + h * h / 12 * w1.cross(w) +
           h * h * h / 24 * w2.cross(w);
}

// The orientation of a body of revolution after a step without torque: a rotation about its axis a,
// then a rotation about L, exp(h i L) exp(h k (L·a) a) q, see constant_wrench_step.hpp.
Quaternion turned_symmetric(const RigidBody& body, const RigidState& state, double h)
{
    const Matrix3d& J_body = body.inverse.inverse_inertia;
    const Vector3d& L = state.angular_momentum;
    const double along = body.symmetry_axis.dot(J_body * body.symmetry_axis); // i + k
    const double i = (J_body.trace() - along) / 2, k = along - i;
    const Vector3d a = body_rotation(Integrator::runge_kutta, state) * body.symmetry_axis;
    return advance_exact(advance_exact(state.orientation, k * L.dot(a) * a, h), i * L, h);
}

// The exact mean angular velocity Ω of a body without torque over the step.
Vector3d mean_of_free_rotation(const RigidBody& body, const RigidState& state, double h)
{
    const Matrix3d axes = body_rotation(Integrator::exact, state) * body.principal_axes;
    return axes * mean_free_angular_velocity(body.inverse_moments,
                                             axes.transpose() * state.angular_momentum, h);
}

// Whether the series for the mean angular velocity Ω is exact up to rounding. The first term that
// the series leaves out is, relative to Ω, some thousandths of (|I⁻¹| |L| h)⁵.
bool is_series_exact(const RigidBody& body, const RigidState& state, double h)
{
    constexpr double most = 1e-3; // [rad]
    return body.inverse.inverse_inertia.norm() * state.angular_momentum.norm() * h < most;
}

} // namespace

RigidState constant_wrench_step(const RigidBody& body, const RigidState& state,
                                const Wrench& wrench, double time_step, FreeRotation free_rotation)
{
    const double h = time_step;
    const Vector3d A = body.inverse.inverse_mass * wrench.force;
    const Vector3d& L = state.angular_momentum;

    RigidState next = state;
    next.position += h * state.velocity + h * h / 2 * A;
    next.velocity += h * A;
    next.angular_momentum += h * wrench.torque;
    const bool is_free = wrench.torque.isZero(0);
    if (body.is_body_of_revolution() && is_free) {
        next.orientation = turned_symmetric(body, state, h);
        return next;
    }
    if (is_free && free_rotation == FreeRotation::exact && !body.is_isotropic &&
        !is_series_exact(body, state, h)) {
        next.orientation =
            advance_exact(state.orientation, mean_of_free_rotation(body, state, h), h);
        return next;
    }
    const Matrix3d J = inverse_inertia(Integrator::runge_kutta, body, state);
    const Vector3d w =
        body.is_isotropic && is_free ? J * L : mean_angular_velocity(J, L, wrench.torque, h);
    next.orientation = advance_exact(state.orientation, w, h);
    return next;
}

} // namespace rigor
