// SPDX-License-Identifier: MIT
// A can that is tilted and let go with a little spin rocks down on its rim, but does not lie down:
// the contact runs to the other side of the rim, and the can rises again in another direction as
// high as before (Srinivasan and Ruina 2008, "Rocking and rolling: a can that appears to rock might
// actually roll"). It may roll or slide; either way it loses no energy.
#include "classics/problems.hpp"

namespace rocking_can {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double R = 0.2, half = 0.15; // radius and half of the height [m]

// A can on its rim, tilted by `angle`, which turns about the horizontal axis through the point of
// the rim that touches, at the rate `omega`.
RigidBody tilted_can(double angle, double omega, double friction)
{
    RigidBody can = body_of(Cylinder{R, 2 * half}, {0, 0, 0}, {0, friction});
    set_mass(can, 1, can.inertia / can.mass);
    const Vector3d up(std::sin(angle), std::cos(angle), 0);
    const Vector3d lowest = -half * up + R * Vector3d(std::cos(angle), -std::sin(angle), 0);
    can.state.orientation = turn({0, 0, 1}, -angle);
    can.state.position = {0, -lowest.y(), 0};
    spin(can, {omega, 0, 0});
    can.state.velocity = -Vector3d(omega, 0, 0).cross(lowest);
    return can;
}

double tilt_of(const RigidBody& can)
{
    return std::acos(std::min(1.0, rotation_matrix(can.state.orientation)(1, 1)));
}

// The energy above that of the can that lies flat at rest [J].
double energy_above_flat(const RigidBody& can)
{
    return energy_of(can) - can.mass * g * half;
}

} // namespace

TEST_CASE("classics: a can that rocks on its rim rises again on the other side", "[classics]")
{
    const double angle = 15 * pi / 180;
    for (const double friction : {0.0, 3.0})
        for (const double omega : {0.2, 0.5})
            for (const double h : {0.01, 0.005, 0.0025}) {
                CAPTURE(friction, omega, h);
                World world =
                    solved({fixed(Plane{}, {0, friction}), tilted_can(angle, omega, friction)});
                world.settings.optimisations.sleep = false;
                const double before = energy_above_flat(world.bodies[1]);
                double lowest = angle, rises_to = 0;
                for (double t = 0; t < 0.8; t += h) {
                    step(world, h);
                    const double tilt = tilt_of(world.bodies[1]);
                    if (tilt < lowest) rises_to = 0;
                    lowest = std::min(lowest, tilt);
                    rises_to = std::max(rises_to, tilt);
                }
                check_at_most(lowest, angle / 6, "lowest tilt [rad]");
                check_at_least(lowest, angle / 60, "lowest tilt [rad]");
                check_at_least(energy_above_flat(world.bodies[1]) / before, 0.99,
                               "energy that is left");
                check_at_least(rises_to, 0.9 * angle, "tilt on the other side [rad]");
            }
}

} // namespace rocking_can
