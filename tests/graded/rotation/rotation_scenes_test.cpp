// SPDX-License-Identifier: MIT
// A3.17: scenes of free bodies, compared with exact solutions.
#include "support/free_rotor.hpp"
#include "support/in_words.hpp"
#include "support/scene_run.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

Quaternion to_quaternion(const Eigen::Quaterniond& q)
{
    return {q.w(), q.vec()};
}

// Error of the orientation of a free box of 1 × 2 × 3 m at the end of the run [rad].
double box_error(double h)
{
    const FreeRotor exact(Vector3d(13, 10, 5), Vector3d(1, 2, 3));
    const Trajectory run = run_scene("a3-rotation/spinning_box", h);
    const double t = steps_of(run.frames.back()) * h;
    return angle_between(run.frames.back().bodies[0].orientation,
                         to_quaternion(exact.orientation(t)));
}

} // namespace

TEST_CASE("rotation: a free box by the method of Buss converges at second order",
          "[A3.17][rotation][scene]")
{
    check_order({box_error(0.01), box_error(0.005), box_error(0.0025)}, 2);
}

TEST_CASE("rotation: a body that no torque acts on keeps its angular momentum",
          "[A3.17][rotation][scene]")
{
    for (const char* scene : {"a3-rotation/spinning_box", "a3-rotation/symmetric_top",
                              "a3-rotation/tennis_racket", "a3-rotation/thrown_box"}) {
        const Trajectory run = run_scene(scene);
        const Vector3d L = run.frames.front().bodies[0].angular_momentum;
        for (const Frame& frame : run.frames) {
            CAPTURE(scene, frame.step);
            INFO("the angular momentum stays the same");
            REQUIRE_THAT(frame.bodies[0].angular_momentum,
                         IsClose(L, Rounding(4 * (1 + steps_of(frame)))));
        }
    }
}

TEST_CASE("rotation: quaternions stay unit over a whole run", "[A3.17][rotation][scene]")
{
    for (const char* scene : {"a3-rotation/spinning_box", "a3-rotation/symmetric_top",
                              "a3-rotation/tennis_racket", "a3-rotation/thrown_box"}) {
        const Trajectory run = run_scene(scene);
        for (const Frame& frame : run.frames) {
            CAPTURE(scene, frame.step);
            const Quaternion& q = frame.bodies[0].orientation;
            const double length = std::sqrt(q.s * q.s + q.v.squaredNorm());
            // advance_exact multiplies unit quaternions: rounding adds up by a few eps in each step
            INFO("the length of the quaternion");
            REQUIRE_THAT(length, IsClose(1.0, Rounding(4 * (1 + steps_of(frame)), 1)));
        }
    }
}

TEST_CASE("rotation: the tennis racket flips as the exact solution does",
          "[A3.17][rotation][scene]")
{
    std::vector<double> errors;
    int flips = 0;
    for (const double h : {0.004, 0.002, 0.001}) {
        const Trajectory run = run_scene("a3-rotation/tennis_racket", h);
        const FreeRotor exact(run.bodies[0].inertia.diagonal(),
                              run.scene.bodies[0].angular_velocity);
        const double t = steps_of(run.frames.back()) * h;
        errors.push_back(angle_between(run.frames.back().bodies[0].orientation,
                                       to_quaternion(exact.orientation(t))));

        const Statistics statistics(run.scene, run.bodies);
        double before = 0;
        flips = 0;
        for (const Frame& frame : run.frames) {
            const RigidState& state = frame.bodies[0];
            const Eigen::Quaterniond q(state.orientation.s, state.orientation.v.x(),
                                       state.orientation.v.y(), state.orientation.v.z());
            // ω about the middle axis, in object space
            const double w = (q.conjugate() * statistics.angular_velocity(0, state)).x();
            if (w * before < 0) ++flips;
            before = w;
        }
    }
    // Near the separatrix the error is that of the period. The period follows from the energy,
    // whose error is one order higher than that of the method.
    check_order(errors, 5);
    check_that(flips >= 2, "the racket flips twice at least");
}

TEST_CASE("rotation: the axis of a symmetric top precesses about L at the rate L over I",
          "[A3.17][rotation][scene]")
{
    std::vector<double> errors;
    for (const double h : {0.004, 0.002, 0.001}) {
        const Trajectory run = run_scene("a3-rotation/symmetric_top", h);
        const RigidState& end = run.frames.back().bodies[0];
        const Vector3d L = run.frames.front().bodies[0].angular_momentum;
        const double t = steps_of(run.frames.back()) * h;
        // the axis starts along z and turns about L by |L| t / I, with I = 0.04 kg m²
        const Eigen::AngleAxisd precession(L.norm() * t / 0.04, L.normalized());
        const Vector3d exact = precession * Vector3d::UnitZ();
        const Eigen::Quaterniond q(end.orientation.s, end.orientation.v.x(), end.orientation.v.y(),
                                   end.orientation.v.z());
        errors.push_back((q * Vector3d::UnitZ() - exact).norm());
    }
    check_order(errors, 1); // the lecture's update holds ω constant over the step
}

TEST_CASE("rotation: a box thrown by symplectic Euler falls as its closed form says",
          "[A3.17][rotation][scene]")
{
    const Trajectory run = run_scene("a3-rotation/thrown_box");
    const RigidState& start = run.frames.front().bodies[0];
    const double h = run.scene.time_step;
    const Vector3d g = run.scene.settings.gravity;
    for (const Frame& frame : run.frames) {
        const double n = steps_of(frame);
        CAPTURE(n);
        // xₙ = x₀ + n h v₀ + g h² n (n + 1) / 2
        const Vector3d x = start.position + n * h * start.velocity + h * h * n * (n + 1) / 2 * g;
        const double scale = start.position.norm() + n * h * start.velocity.norm() +
                             h * h * n * (n + 1) / 2 * g.norm();
        INFO("the position of symplectic Euler after n steps, x₀ + n h v₀ + g h² n (n + 1)/2");
        REQUIRE_THAT(frame.bodies[0].position, IsClose(x, Rounding(8 * (1 + n), scale)));
    }
}
