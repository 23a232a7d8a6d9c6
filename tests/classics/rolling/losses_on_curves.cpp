// SPDX-License-Identifier: MIT
// A contact that moves along a curved surface does no work if nothing slips. In steps it does a
// little, since the normal and the lever of the start hold for all of the step: the loss goes down
// with the first power of the step, and is no gain.
#include "classics/problems.hpp"

#include "geometry/meshes/generators.hpp"

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

TEST_CASE("classics: a body in a faceted bowl gains no energy", "[classics]")
{
    Sweep sweep;
    // The wall ahead is steeper than the wall below, in corners or along a curve. A body that moves
    // into it and is pushed out again would be lifted by nothing.
    struct Named {
        const char* name;
        Shape shape;
    };
    const std::vector<Named> shapes = {{"sphere", Sphere{0.1}},
                                       {"capsule", Capsule{0.08, 0.1}},
                                       {"torus", Torus{0.08, 0.03}},
                                       {"box", Box{{0.12, 0.12, 0.12}}},
                                       {"cylinder", Cylinder{0.08, 0.12}},
                                       {"ellipsoid", Ellipsoid{{0.1, 0.08, 0.06}}},
                                       {"icosphere", mesh_of(icosphere(0.1, 3))},
                                       {"ring", mesh_of(ring_mesh(0.07, 0.1, 0.05, 48))}};
    for (const int sides : {24, 96}) {
        const Shape bowl = mesh_of(bowl_mesh(1.1, 0.1, sides));
        for (const auto& [name, shape] : shapes)
            for (const double friction : {0., 0.5})
                for (const double h : {0.02, 0.005}) {
                    if (!sweep.takes_next()) continue;
                    CAPTURE(sides, name, friction, h);
                    const Material material{0, friction};
                    World world =
                        solved({fixed(bowl, material), body_of(shape, {0.35, -0.75, 0.05}, material,
                                                               turn({1, 2, 3}, 0.7))});
                    const RigidBody& body = world.bodies[1];
                    const double bottom = -body.mass * g, first = energy(body) - bottom;
                    double least = first, rise = 0;
                    while (world.time < 4) {
                        step(world, h);
                        least = std::min(least, energy(body) - bottom);
                        rise = std::max(rise, (energy(body) - bottom - least) / first);
                    }
                    check_at_most(rise, 0.02, "energy that was gained");
                    check_at_least(least, 0, "energy above the bottom");
                }
    }
}

TEST_CASE("classics: a ball swings in a faceted bowl or ring without a gain", "[classics]")
{
    Sweep sweep;
    const Material smooth{0, 0};
    for (const int sides : {12, 48, 180})
        for (const bool is_ring : {false, true}) {
            const Shape wall =
                mesh_of(is_ring ? ring_mesh(1, 1.2, 1, sides) : bowl_mesh(1.1, 0.1, sides));
            const Quaternion q = is_ring ? turn({1, 0, 0}, pi / 2) : Quaternion{};
            for (const double start : {0.2, 1.2}) // from the vertical [rad]
                for (const double h : {0.02, 0.01, 0.005}) {
                    if (!sweep.takes_next()) continue;
                    CAPTURE(sides, is_ring, start, h);
                    const Vector3d X = 0.89 * std::cos(pi / sides) *
                                       Vector3d(std::sin(start), -std::cos(start), 0);
                    World world = solved(
                        {fixed(wall, smooth, {0, 0, 0}, q), body_of(Sphere{0.1}, X, smooth)});
                    const RigidBody& ball = world.bodies[1];
                    const double bottom = -0.9 * ball.mass * g, first = energy(ball) - bottom;
                    double most = 0;
                    while (world.time < 10) {
                        step(world, h);
                        most = std::max(most, energy(ball) - bottom);
                    }
                    check_at_most(most / first, 1 + 1e-3, "energy");
                }
        }
}

} // namespace losses_on_curves
