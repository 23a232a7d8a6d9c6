// SPDX-License-Identifier: MIT
// Runge–Kutta 4 for rigid bodies, written once for both representations of an orientation: as a
// matrix, and as a quaternion by the method of Munthe-Kaas (1999, see free_flight.hpp).
#pragma once

#include "formulas/inertia.hpp"
#include "formulas/kinematics.hpp"
#include "formulas/rotation.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/orientation.hpp"

#include <array>
#include <span>

namespace rigor {

/// A body, with its state and its rates at the stages of a step.
template <class Scheme> struct BodyStages {
    BodyStages(const RigidBody& moving, const typename Scheme::State& from, const Wrench& pull)
        : body(&moving), start(from), stage(from), wrench(pull)
    {
    }

    const RigidBody* body;
    typename Scheme::State start, stage;
    Wrench wrench;                              // at the current stage
    std::array<typename Scheme::Rate, 4> rates; // one for each stage so far
};

/// Advances all bodies by the time h together, since they may pull on each other. Afterwards,
/// `stage` of each body is its state at the end of the step.
///
/// @param update_wrenches  called at each stage; sets the wrenches of the bodies if these change
///                         from stage to stage
template <class Scheme, class Update>
void runge_kutta_4(std::span<BodyStages<Scheme>> bodies, double h, Update&& update_wrenches)
{
    constexpr double offsets[] = {0, 0.5, 0.5, 1};
    for (int s = 0; s < 4; ++s) {
        for (BodyStages<Scheme>& b : bodies)
            if (s > 0)
                b.stage = Scheme::advance(b.start, Scheme::slope(b.rates, s, h), offsets[s] * h);
        update_wrenches();
        for (BodyStages<Scheme>& b : bodies)
            b.rates[s] = Scheme::rate(*b.body, b.stage, b.wrench);
    }
    for (BodyStages<Scheme>& b : bodies)
        b.stage = Scheme::advance(b.start, Scheme::slope(b.rates, 4, h), h);
}

/// Classical Runge–Kutta 4 on (X, R, V, L), through `equations_of_motion`.
struct MatrixScheme {
    using State = MatrixState;
    using Rate = MatrixStateRate;

    static State from(const RigidState& s)
    {
        return {s.position, rotation_matrix(s.orientation), s.velocity, s.angular_momentum};
    }

    /// Makes R a rotation again, by converting R to a unit quaternion. Of the two quaternions of
    /// the rotation, q and -q, the one nearer to `previous` is taken.
    static RigidState to(const State& s, const RigidState& previous)
    {
        return {s.position, nearer_quaternion_of(s.rotation, previous.orientation), s.velocity,
                s.angular_momentum};
    }

    /// R + h Ṙ is not a rotation: at the stages inside a step, R differs from a rotation by O(h²).
    /// Therefore the formulas get the rotation nearest to R. This rotation is a smooth function of
    /// R, and equal to R if R is a rotation, so the order stays 4.
    static Rate rate(const RigidBody& body, State s, const Wrench& wrench)
    {
        s.rotation = nearest_rotation(s.rotation);
        const Matrix3d& I_inverse = body.inverse.inverse_inertia;
        return equations_of_motion(
            s, body.inverse.inverse_mass,
            body.is_isotropic ? I_inverse : world_inverse_inertia(s.rotation, I_inverse), wrench);
    }

    /// The rotation Q with the smallest ‖Q - A‖: Q = U diag(1, 1, det(U Vᵀ)) Vᵀ for A = U Σ Vᵀ.
    static Matrix3d nearest_rotation(const Matrix3d& A)
    {
        const Eigen::JacobiSVD<Matrix3d> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
        Matrix3d U = svd.matrixU();
        const Matrix3d& V = svd.matrixV();
        if (U.determinant() * V.determinant() < 0) U.col(2) = -U.col(2);
        return U * V.transpose();
    }

    static Rate slope(const std::array<Rate, 4>& k, int stage, double)
    {
        if (stage < 4) return k[stage - 1];
        const auto mean = [&k](auto field) {
            return ((k[0].*field + 2 * k[1].*field + 2 * k[2].*field + k[3].*field) / 6).eval();
        };
        return {mean(&Rate::position_rate), mean(&Rate::rotation_rate), mean(&Rate::velocity_rate),
                mean(&Rate::angular_momentum_rate)};
    }

    static State advance(const State& s, const Rate& k, double h)
    {
        return {s.position + h * k.position_rate, s.rotation + h * k.rotation_rate,
                s.velocity + h * k.velocity_rate, s.angular_momentum + h * k.angular_momentum_rate};
    }
};

/// The method of Munthe-Kaas on (X, q, V, L), see free_flight.hpp.
struct LieScheme {
    using State = RigidState;
    struct Rate {
        Vector3d V = Vector3d::Zero(), omega = Vector3d::Zero(), A = Vector3d::Zero(),
                 torque = Vector3d::Zero();
    };

    static State from(const RigidState& s) { return s; }
    static RigidState to(const State& s, const RigidState&) { return s; }

    static Rate rate(const RigidBody& body, const State& s, const Wrench& wrench)
    {
        const Matrix3d I_inverse = inverse_inertia(Integrator::runge_kutta, body, s);
        return {s.velocity, I_inverse * s.angular_momentum,
                body.inverse.inverse_mass * wrench.force, wrench.torque};
    }

    static Rate slope(const std::array<Rate, 4>& k, int stage, double h)
    {
        if (stage == 4) {
            const auto mean = [&k](Vector3d Rate::*field) -> Vector3d {
                return (k[0].*field + 2 * (k[1].*field + k[2].*field) + k[3].*field) / 6;
            };
            return {mean(&Rate::V), mean(&Rate::omega) - h / 12 * k[0].omega.cross(k[3].omega),
                    mean(&Rate::A), mean(&Rate::torque)};
        }
        Rate slope = k[stage - 1];
        // The stage advances by h/2 along this slope: ½ ω₂ - h/8 ω₁ × ω₂ = ½ (ω₂ - h/4 ω₁ × ω₂)
        if (stage == 2) slope.omega -= h / 4 * k[0].omega.cross(k[1].omega);
        return slope;
    }

    static State advance(const State& s, const Rate& k, double h)
    {
        return {s.position + h * k.V, advance_exact(s.orientation, k.omega, h),
                s.velocity + h * k.A, s.angular_momentum + h * k.torque};
    }
};

} // namespace rigor
