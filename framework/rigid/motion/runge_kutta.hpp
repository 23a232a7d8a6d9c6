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

/// A body during the stages of a step.
template <class Scheme> struct Track {
    Track(const RigidBody& moving, const typename Scheme::State& from, const Wrench& pull)
        : body(&moving), start(from), stage(from), wrench(pull)
    {
    }

    const RigidBody* body;
    typename Scheme::State start, stage;
    Wrench wrench;                              // at the current stage
    std::array<typename Scheme::Rate, 4> rates; // one for each stage so far
};

/// Advances all tracks by h together, since their bodies may pull on each other.
///
/// @param update_wrenches  called at each stage; sets the tracks' wrenches if they depend on the
///                         stage
template <class Scheme, class Update>
void runge_kutta_4(std::span<Track<Scheme>> tracks, double h, Update&& update_wrenches)
{
    constexpr double offsets[] = {0, 0.5, 0.5, 1};
    for (int s = 0; s < 4; ++s) {
        for (Track<Scheme>& t : tracks)
            if (s > 0)
                t.stage = Scheme::advance(t.start, Scheme::slope(t.rates, s, h), offsets[s] * h);
        update_wrenches();
        for (Track<Scheme>& t : tracks)
            t.rates[s] = Scheme::rate(*t.body, t.stage, t.wrench);
    }
    for (Track<Scheme>& t : tracks)
        t.stage = Scheme::advance(t.start, Scheme::slope(t.rates, 4, h), h);
}

/// Classical Runge–Kutta 4 on (X, R, V, L), through `equations_of_motion`.
struct MatrixScheme {
    using State = MatrixState;
    using Rate = MatrixStateRate;

    static State from(const RigidState& s)
    {
        return {s.position, rotation_matrix(s.orientation), s.velocity, s.angular_momentum};
    }

    /// R becomes a rotation again. Of its two quaternions, the one nearer to the previous one is
    /// taken.
    static RigidState to(const State& s, const RigidState& previous)
    {
        Quaternion q = quaternion_of(s.rotation);
        const Quaternion& p = previous.orientation;
        if (q.s * p.s + q.v.dot(p.v) < 0) q = {-q.s, -q.v};
        return {s.position, q, s.velocity, s.angular_momentum};
    }

    static Rate rate(const RigidBody& body, const State& s, const Wrench& wrench)
    {
        const Matrix3d& I_inverse = body.inverse.inverse_inertia;
        return equations_of_motion(
            s, body.inverse.inverse_mass,
            body.is_isotropic ? I_inverse : world_inverse_inertia(s.rotation, I_inverse), wrench);
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
        // The stage advances by h/2 along this slope, so the ⅛ of the commutator becomes a ¼ here.
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
