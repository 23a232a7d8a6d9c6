// SPDX-License-Identifier: MIT
// A contact that moves along a curved surface does no work if nothing slips. In steps it does a
// little. Between smooth shapes this goes down with the third power of the step, or the second if
// the body begins to roll from rest (step/midpoint/midpoint_contact.hpp). On a mesh, where the
// normal jumps, it is a loss.
#include "classics/problems.hpp"

#include "geometry/meshes/generators.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace losses_on_curves {

namespace {

// The share of its fall that a ball loses until it leaves a sphere with the radius 1 m.
double lost_until_it_leaves(double radius, double friction, double h)
{
    const Material material{0, friction};
    const double start = 0.1; // from the vertical [rad]
    const Vector3d X = (1 + radius) * Vector3d(std::sin(start), std::cos(start), 0);
    World world = solved({fixed(Sphere{1}, material), body_of(Sphere{radius}, X, material)});
    const RigidBody& ball = world.bodies[1];
    const double first = energy_of(ball);
    for (bool touches = true; touches || world.time < 3 * h;)
        touches = !step(world, h).empty();
    return (first - energy_of(ball)) / (ball.mass * g * (X.y() - ball.state.position.y()));
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

TEST_CASE("classics: a ball leaves a sphere with all of its energy", "[classics]")
{
    for (const double radius : {0.1, 0.5})
        for (const double friction : {0., 100.})
            for (const double h : {0.02, 0.01, 0.005, 0.0025, 0.00125}) {
                CAPTURE(radius, friction, h);
                const double lost = lost_until_it_leaves(radius, friction, h);
                const double bound = friction == 0 ? 25 * h * h * h : h * h;
                check_at_most(std::abs(lost), bound, "share of the fall");
            }
}

TEST_CASE("classics: a disk that rolls on its rim keeps its energy", "[classics]")
{
    // The error after one second, with steps of a millisecond. At 3 degrees the disk has
    // ω = 7 rad/s, and its contact goes around a circle of almost the disk's radius twenty times.
    struct Disk {
        double degrees, lost;
    };
    for (const auto& [degrees, lost] :
         {Disk{3, 0.01}, Disk{10, 1e-4}, Disk{30, 1e-4}, Disk{50, 1e-5}, Disk{70, 1e-6}})
        for (const double h : {0.002, 0.001, 0.0005}) {
            CAPTURE(degrees, h);
            World world = rolling_on_its_rim(degrees * pi / 180);
            const double first = energy_of(world.bodies[1]);
            double most = 0;
            while (world.time < 1 - h / 2) {
                step(world, h);
                most = std::max(most, energy_of(world.bodies[1]));
            }
            check_at_most(most / first, 1 + 1e-5, "energy");
            const double order = std::max(1.0, std::pow(h / 0.001, 3));
            check_at_least(energy_of(world.bodies[1]) / first, 1 - order * lost, "energy");
        }
}

TEST_CASE("classics: a disk that is nearly flat rolls on at any step", "[classics]")
{
    // The contact goes round the rim up to 300 times a second.
    for (const double angle : {0.3, 0.1, 0.03, 0.01})
        for (const double h : {0.01, 0.005, 0.002}) {
            CAPTURE(angle, h);
            World world = rolling_on_its_rim(angle);
            world.settings.optimisations.sleep = false;
            const double first = energy_of(world.bodies[1]);
            run_until(world, 0.5, h);
            check_at_least(energy_of(world.bodies[1]) / first, 0.98, "energy");
            check_at_most(energy_of(world.bodies[1]) / first, 1.001, "energy");
        }
}

TEST_CASE("classics: a stick that turns about its foot keeps its energy", "[classics]")
{
    for (const double width : {0.02, 0.1})
        for (const double depth : {0.1, 0.4})
            for (const double start : {0.2, 0.6}) // from the vertical [rad]
                for (const double h : {0.01, 0.005, 0.0025}) {
                    CAPTURE(width, depth, start, h);
                    const Material rough{0, 10};
                    const Quaternion q = turn({0, 0, 1}, start);
                    const Vector3d foot(width / 2, -0.5, 0);
                    RigidBody stick = body_of(Box{{width, 1, depth}}, {0, 0, 0}, rough, q);
                    stick.state.position = -(rotation_matrix(q) * Vector3d(-foot.x(), foot.y(), 0));
                    World world = solved({fixed(Plane{}, rough), stick});
                    const double first = energy_of(world.bodies[1]);
                    while (world.time < 0.2)
                        step(world, h);
                    const double work = stick.mass * g * 0.5; // the fall from upright to flat
                    check_at_most(std::abs(energy_of(world.bodies[1]) - first) / work, 10 * h * h,
                                  "share of the fall");
                }
}

TEST_CASE("classics: a pebble and an egg rock on with their energy", "[classics]")
{
    for (const Vector3d& half : {Vector3d(0.2, 0.1, 0.1), Vector3d(0.3, 0.1, 0.3)})
        for (const double tilt : {0.1, 0.4})
            for (const double friction : {0., 10.})
                for (const double h : {0.01, 0.005, 0.0025}) {
                    CAPTURE(half, tilt, friction, h);
                    const Material material{0, friction};
                    RigidBody egg =
                        body_of(Ellipsoid{half}, {0, 0, 0}, material, turn({0, 0, 1}, tilt));
                    egg.state.position.y() =
                        std::hypot(half.x() * std::sin(tilt), half.y() * std::cos(tilt));
                    World world = solved({fixed(Plane{}, material), egg});
                    const double rest = egg.mass * g * half.y();
                    const double first = energy_of(world.bodies[1]) - rest;
                    while (world.time < 3)
                        step(world, h);
                    const double lost = 1 - (energy_of(world.bodies[1]) - rest) / first;
                    check_at_most(std::abs(lost), (tilt > 0.2 ? 2000 : 600) * h * h,
                                  "share of the energy");
                }
}

TEST_CASE("classics: a body in a faceted bowl gains no energy", "[classics][.long][unsanitized]")
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
                    const double bottom = -body.mass * g, first = energy_of(body) - bottom;
                    double least = first, rise = 0;
                    while (world.time < 4) {
                        step(world, h);
                        least = std::min(least, energy_of(body) - bottom);
                        rise = std::max(rise, (energy_of(body) - bottom - least) / first);
                    }
                    check_at_most(rise, 0.02, "energy that was gained");
                    check_at_least(least, 0, "energy above the bottom");
                }
    }
}

TEST_CASE("classics: a ball swings in a faceted bowl or ring without a gain",
          "[classics][unsanitized]")
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
                    const double bottom = -0.9 * ball.mass * g, first = energy_of(ball) - bottom;
                    double most = 0;
                    while (world.time < 10) {
                        step(world, h);
                        most = std::max(most, energy_of(ball) - bottom);
                    }
                    check_at_most(most / first, 1 + 1e-3, "energy");
                }
        }
}

} // namespace losses_on_curves
