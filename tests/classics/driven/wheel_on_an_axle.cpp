// SPDX-License-Identifier: MIT
// A body on a fixed axle swings under a steady force as a pendulum, ω² = F R/I with the moment of
// inertia I about the axle (Bessel 1828), and one that is braked by d ω under the torque τ nears
// τ/d. The axle takes up all other moments.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a wheel on its axle swings by its moment about it", "[classics]")
{
    const double F = 20, R = 0.5, tau = 3, d = 2, T = 4, I = 5;
    RigidBody wheel = free_box();
    set_mass(wheel, 12, (Matrix3d() << 13, 1, 0.5, 1, 10, -1, 0.5, -1, I).finished());
    let_turn_about(wheel, {0, 0, 2}); // not a principal axis

    const double w = std::sqrt(F * R / I), angle = 0.8;
    RigidBody swings = wheel;
    swings.state.orientation = turn({0, 0, 1}, angle);
    AppliedForce pull;
    pull.force = {0, -F, 0};
    pull.point = {0, -R, 0};
    World world = solved({swings}, {0, 0, 0});
    world.forces = {pull};
    const double quarter = std::comp_ellint_1(std::sin(angle / 2)) / w;
    run(world, 200, quarter / 200);
    CHECK_THAT(world.bodies[0].state.orientation.v, IsClose(Vector3d(0, 0, 0), Order(1e-7)));
    CHECK_THAT(angular_velocity(world.bodies[0]),
               IsClose(Vector3d(0, 0, -2 * w * std::sin(angle / 2)), Order(1e-7)));

    RigidBody braked = wheel;
    braked.drag = {0, 0, d};
    AppliedForce drive;
    drive.torque = {1, -2, tau};
    World mill = solved({braked}, {0, 0, 0});
    mill.forces = {drive};
    run(mill, 200, T / 200);
    const double last = tau / d * (1 - std::exp(-d * T / I));
    CHECK_THAT(angular_velocity(mill.bodies[0]), IsClose(Vector3d(0, 0, last), Order(1e-6)));
}
