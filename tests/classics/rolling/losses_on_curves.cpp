// SPDX-License-Identifier: MIT
// A contact that moves along a curved surface does no work if nothing slips. In steps it does a
// little, since the normal and the lever of the start hold for all of the step: the loss goes down
// with the first power of the step, and is no gain.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace losses_on_curves {

namespace {

double energy(const RigidBody& body)
{
    const Vector3d w = angular_velocity(body);
    const RigidState& s = body.state;
    return body.mass * (s.velocity.squaredNorm() / 2 + g * s.position.y()) +
           w.dot(s.angular_momentum) / 2;
}

// The share of its fall that a ball loses until it leaves a sphere with the radius 1 m.
double lost_until_it_leaves(double radius, double friction, double h)
{
    const Material material{0, friction};
    const double start = 0.1; // from the vertical [rad]
    const Vector3d X = (1 + radius) * Vector3d(std::sin(start), std::cos(start), 0);
    World world = solved({fixed(Sphere{1}, material), body_of(Sphere{radius}, X, material)});
    const RigidBody& ball = world.bodies[1];
    const double first = energy(ball);
    for (bool touches = true; touches || world.time < 3 * h;)
        touches = !step(world, h).empty();
    return (first - energy(ball)) / (ball.mass * g * (X.y() - ball.state.position.y()));
}

// A thin disk that rolls on its rim, inclined by an angle, with its center at rest: ω points to the
// contact, with ω² = 4 g sin α/a (Euler's disk; Moffatt 2000).
World rolling_on_its_rim(double angle)
{
    const double a = 0.04, thickness = 0.01 * a;
    const Material rough{0, 10};
    RigidBody disk = body_of(Cylinder{a, thickness}, {0, 0, 0}, rough, turn({0, 0, 1}, -angle));
    const Vector3d axis(std::sin(angle), std::cos(angle), 0);
    const Vector3d to_rim(std::cos(angle), -std::sin(angle), 0);
    const Vector3d r = a * to_rim - thickness / 2 * axis;
    disk.state.position = {0, -r.y(), 0};
    spin(disk, std::sqrt(4 * g * std::sin(angle) / a) * r.normalized());
    return solved({fixed(Plane{}, rough), disk});
}

} // namespace

TEST_CASE("classics: a ball rolls off a sphere with a loss of the first order", "[classics]")
{
    for (const double radius : {0.1, 0.5})
        for (const double friction : {0., 100.})
            for (const double h : {0.02, 0.01, 0.005, 0.0025, 0.00125}) {
                CAPTURE(radius, friction, h);
                const double lost = lost_until_it_leaves(radius, friction, h);
                check_at_least(lost, 0, "share of the fall");
                check_at_most(lost, 3 * h, "share of the fall");
            }
}

TEST_CASE("classics: a disk that rolls on its rim loses little energy and gains none", "[classics]")
{
    struct Disk {
        double degrees, kept; // share of its energy after a second
    };
    for (const auto& [degrees, kept] : {Disk{30, 0.91}, Disk{50, 0.95}})
        for (const double h : {0.002, 0.001, 0.0005}) {
            CAPTURE(degrees, h);
            World world = rolling_on_its_rim(degrees * pi / 180);
            const double first = energy(world.bodies[1]);
            double most = 0;
            while (world.time < 1 - h / 2) {
                step(world, h);
                most = std::max(most, energy(world.bodies[1]));
            }
            // The position correction leaves an overlap of a millionth of the radius, or lifts it.
            check_at_most(most / first, 1 + 1e-6, "energy");
            check_at_least(energy(world.bodies[1]) / first, kept, "energy");
        }
}

} // namespace losses_on_curves
