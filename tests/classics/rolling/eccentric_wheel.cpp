// SPDX-License-Identifier: MIT
// A wheel whose center of mass is not in its middle rolls to and fro on the ground. It loses no
// energy, so it comes as far on one side as on the other. The contact turns slowly at the ends of
// the way, and fast in the middle.
#include "classics/problems.hpp"

namespace eccentric_wheel {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double R = 0.5;   // radius [m]
constexpr double off = 0.3; // distance of the center of mass from the middle [m]

// The wheel with its axis along z, its center of mass `angle` away from its lowest place.
RigidBody eccentric(const Shape& shape, double angle)
{
    RigidBody wheel = body_of(shape, {0, 0, 0}, {0, 3});
    wheel.parts[0].position = {0, off, 0};
    wheel.parts[0].orientation = turn({1, 0, 0}, pi / 2);
    set_mass(wheel, 3, 0.3 * Matrix3d::Identity());
    wheel.state.orientation = turn({0, 0, 1}, angle);
    wheel.state.position = {off * std::sin(angle), R - off * std::cos(angle), 0};
    return wheel;
}

} // namespace

TEST_CASE("classics: a wheel with an eccentric mass rolls to and fro", "[classics]")
{
    const double angle = 100 * pi / 180, T = 5.9;
    const double scale = 3 * g * off * (1 - std::cos(angle)); // energy of the swing [J]
    for (const Shape& shape : {Shape(Cylinder{R, 0.3}), Shape(Sphere{R})})
        for (const double h : {0.02, 0.01, 0.005, 0.0025, 0.00125, 0.000625}) {
            CAPTURE(shape.index(), h);
            World world = solved({fixed(Plane{}, {0, 3}), eccentric(shape, angle)});
            const double before = energy_of(world.bodies[1]);
            run_until(world, T, h);
            const double change = (energy_of(world.bodies[1]) - before) / scale;
            check_at_most(std::abs(change), 50 * h * h, "relative change of the energy");
        }
}

} // namespace eccentric_wheel
