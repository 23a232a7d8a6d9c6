// SPDX-License-Identifier: MIT
// A1.10: scenes of thrown and spinning bodies and of a spring pendulum.
#include "support/in_words.hpp"
#include "support/scene_run.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double energy_change(const Trajectory& run)
{
    const Statistics statistics(run.scene, run.bodies);
    return statistics.of(run.frames.back()).total_energy() -
           statistics.of(run.frames.front()).total_energy();
}

} // namespace

TEST_CASE("kinematics: a thrown body's center flies a parabola however it spins",
          "[A1.10][kinematics][scene]")
{
    const Trajectory run = run_scene("a1-kinematics/projectile_with_spin");
    const Vector3d g = run.scene.settings.gravity;
    for (const char* name : {"spinning", "still"}) {
        const auto i = static_cast<std::size_t>(body_index(run, name));
        const BodyDescription& start = run.scene.bodies[i];
        for (const Frame& frame : run.frames) {
            const double t = steps_of(frame) * run.scene.time_step;
            CAPTURE(name, t);
            // X = X₀ + V₀ t + ½ g t² up to rounding, since fourth order is exact for a parabola
            const double scale =
                start.position.norm() + start.velocity.norm() * t + g.norm() * t * t / 2;
            const double k = 16 * (1 + steps_of(frame));
            REQUIRE_THAT(
                frame.bodies[i].position,
                IsClose(start.position + t * start.velocity + t * t / 2 * g, Rounding(k, scale)));
        }
    }
}

TEST_CASE("kinematics: a body that no torque acts on keeps its angular momentum",
          "[A1.10][kinematics][scene]")
{
    const Trajectory run = run_scene("a1-kinematics/projectile_with_spin");
    const auto i = static_cast<std::size_t>(body_index(run, "spinning"));
    const Vector3d L = run.frames.front().bodies[i].angular_momentum;
    check_that(L.norm() > 0, "a body that spins has an angular momentum");
    for (const Frame& frame : run.frames) {
        CAPTURE(frame.step);
        INFO("the angular momentum stays the same");
        REQUIRE_THAT(frame.bodies[i].angular_momentum, IsClose(L, Rounding(16)));
    }
}

TEST_CASE("kinematics: a spinning cube turns about its fixed axis at fourth order",
          "[A1.10][kinematics][scene]")
{
    std::vector<double> errors;
    for (const double h : {0.02, 0.01, 0.005}) {
        const Trajectory run = run_scene("a1-kinematics/projectile_with_spin", h);
        const auto i = static_cast<std::size_t>(body_index(run, "spinning"));
        const Vector3d w = run.scene.bodies[i].angular_velocity;
        const double t = steps_of(run.frames.back()) * h;
        // a turn by the angle |ω| t about ω / |ω|
        const double half = w.norm() * t / 2;
        const Quaternion exact = {std::cos(half), std::sin(half) * w.normalized()};
        errors.push_back(angle_between(run.frames.back().bodies[i].orientation, exact));
    }
    check_order(errors, 4);
}

TEST_CASE(
    "kinematics: what a spring pendulum loses of its energy falls as the fifth power of the step",
    "[A1.10][kinematics][scene]")
{
    std::vector<double> errors;
    for (const double h : {0.01, 0.005, 0.0025})
        errors.push_back(std::abs(energy_change(run_scene("a1-kinematics/spring_pendulum", h))));
    // Energy is quadratic in the state. For oscillations the energy error of Runge–Kutta 4 is
    // therefore one order higher than the error of the state.
    check_that(errors.back() > 1e3 * eps,
               "a loss of energy above rounding, so that its order can be seen");
    check_order(errors, 5);
}
