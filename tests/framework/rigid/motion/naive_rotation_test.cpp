// SPDX-License-Identifier: MIT
#include "rigid/motion/naive_rotation.hpp"

#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"
#include "support/free_rotor.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

double error_after(Integrator integrator, int steps)
{
    const double end = 1;
    World world = world_of({free_box({1, 2, 3})}, {0, 0, 0});
    world.settings.integrator = integrator;
    run(world, steps, end / steps);
    return rotation_angle(eigen(world.bodies[0].state.orientation),
                          FreeRotor(free_moments, {1, 2, 3}).orientation(end));
}

} // namespace

TEST_CASE("flight: a matrix that Gram-Schmidt repairs falls behind", "[rigid]")
{
    // Both columns in the plane of the rotation turn by atan(ω Δt) instead of ω Δt.
    const Quaternion q = turned_by_gram_schmidt({}, {0, 0, 1}, 0.5);
    CHECK(std::abs(2 * std::atan2(q.v.z(), q.s) - std::atan(0.5)) < 1e-15);
}

TEST_CASE("flight: Euler angles do not turn a body at gimbal lock", "[rigid]")
{
    const double half = std::numbers::pi / 4;
    const Quaternion up = {std::cos(half), {0, std::sin(half), 0}}; // a pitch of 90°
    const Quaternion q = turned_by_euler_angles(up, {1, 0, 0}, 0.1);
    CHECK(std::abs(q.s - up.s) + (q.v - up.v).norm() < 1e-12);
    // Elsewhere they turn it.
    const Quaternion level = turned_by_euler_angles({}, {1, 0, 0}, 0.1);
    CHECK(std::abs(2 * std::atan2(level.v.x(), level.s) - 0.1) < 1e-15);
}

TEST_CASE("flight: the naive methods are of first order", "[rigid]")
{
    for (const Integrator integrator : {Integrator::gram_schmidt, Integrator::euler_angles}) {
        std::vector<double> errors;
        for (const int n : {3200, 6400, 12800})
            errors.push_back(error_after(integrator, n));
        check_order(errors, 1);
    }
}
