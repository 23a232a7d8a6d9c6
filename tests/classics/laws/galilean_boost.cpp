// SPDX-License-Identifier: MIT
// No experiment tells whether a ship stands or moves evenly (Galilei 1632, "Dialogo"): bodies that
// collide, slide, roll and swing on springs do the same if all of them, ground and anchors
// included, have an additional velocity. Only rounding differs: at 1000 m/s a place has an error of
// 1e-13 m after a second, and what tumbles enlarges it.
#include "classics/problems.hpp"

#include <functional>
#include <string>

using namespace rigor;
using namespace rigor::testing;

namespace galilean_boost {
namespace {

using Bodies = std::vector<RigidBody>;

const Material dead{0, 0.5}, lively{0.8, 0.4}, slippery{0.95, 0.05};
constexpr int steps = 80;
constexpr double h = 0.01; // [s]

RigidBody deck(const Material& material)
{
    return fixed(Box{{30, 1, 30}}, material, {0, -0.5, 0});
}

RigidBody thrown(RigidBody body, const Vector3d& velocity, const Vector3d& omega = {0, 0, 0})
{
    body.state.velocity = velocity;
    spin(body, omega);
    return body;
}

// The bodies and all that is fixed, with an additional velocity.
World moving_at(const Vector3d& V, World world)
{
    for (RigidBody& body : world.bodies) {
        body.state.velocity += V;
        if (!body.is_static) continue;
        Drive drive = moving(V);
        drive.first_position = body.state.position;
        drive.first_orientation = body.state.orientation;
        body.drive = std::make_shared<const Drive>(drive);
        body.state = driven_state(drive, 0);
    }
    return world;
}

World ball_on_a_spring()
{
    const Material material{0.6, 0.3};
    World world = solved({deck(material), body_of(Box{{0.4, 0.3, 0.5}}, {0, 0.15, 0}, material),
                          thrown(body_of(Sphere{0.15}, {-0.9, 0.5, 0.05}, material), {3, 0, 0})});
    world.springs = {{0, 1, {2, 1, 0}, {0.2, 0, 0}, 200, 0, 1}};
    return world;
}

World sliding_block()
{
    return solved(
        {deck(dead), thrown(body_of(Box{{0.4, 0.3, 0.5}}, {0, 0.15, 0}, dead), {2, 0, 1})});
}

World block_on_a_slope()
{
    const Material material{0, 0.2};
    return solved({deck(material), body_of(Box{{0.4, 0.3, 0.5}}, {0, 0.15, 0}, material)},
                  gravity_on_slope(0.5));
}

World stack()
{
    Bodies bodies{deck(dead)};
    for (int i = 0; i < 5; ++i)
        bodies.push_back(body_of(Box{{1, 1, 1}}, {0.02 * i, 0.5 + i, 0.01 * i}, dead));
    bodies.back().state.velocity = {0.5, 0, 0.2};
    return solved(bodies);
}

World pile()
{
    Bodies bodies{deck(dead)};
    for (int i = 0; i < 6; ++i)
        bodies.push_back(body_of(Box{{0.5, 0.4, 0.6}}, {0.05 * i, 0.3 + 0.7 * i, -0.04 * i}, dead,
                                 turn({1, 2.0 * i, 0.5}, 0.2 * i)));
    return solved(bodies);
}

World heavy_on_light()
{
    RigidBody heavy = body_of(Box{{1, 1, 1}}, {0.05, 1.9, 0.02}, dead);
    set_mass(heavy, 1000 * heavy.mass, 1000 * heavy.inertia);
    return solved({deck(dead), body_of(Box{{1, 1, 1}}, {0, 0.5, 0}, dead), heavy});
}

World wheel(const Shape& shape)
{
    const RigidBody body = body_of(shape, {0, 0.2, 0}, dead, turn({1, 0, 0}, pi / 2));
    return solved({deck(dead), thrown(body, {1, 0, 0}, {0, 0, -5})});
}

World bouncing_balls()
{
    return solved({deck(lively),
                   thrown(body_of(Sphere{0.1}, {0, 0.5, 0}, lively), {1, 0, 0}, {3, 2, 8}),
                   thrown(body_of(Sphere{0.1}, {0.5, 0.9, 0.01}, lively), {-0.3, 0, 0})});
}

World billiards()
{
    return solved({deck(slippery), thrown(body_of(Sphere{0.03}, {0, 0.03, 0}, slippery), {1, 0, 0}),
                   body_of(Sphere{0.03}, {0.2, 0.03, 0.02}, slippery)});
}

World tumbling_box(double restitution)
{
    const Material material{restitution, 0.4};
    return solved({deck(material),
                   body_of(Box{{0.4, 0.3, 0.5}}, {0, 0.6, 0}, material, turn({1, 2, 3}, 0.7))});
}

// Bodies that meet in free fall or in space, with nothing fixed at all.
World meeting(const Vector3d& gravity)
{
    const Material material{0.3, 0.4};
    return solved({body_of(Box{{1, 1, 1}}, {0, 5, 0}, material),
                   thrown(body_of(Box{{1, 1, 1}}, {1.2, 5.3, 0.1}, material, turn({1, 2, 3}, 0.3)),
                          {-2, 0, 0}),
                   thrown(body_of(Sphere{0.4}, {2.4, 5.1, 0.1}, dead), {-2.5, 0, 0})},
                  gravity);
}

// Bodies that overlap are driven apart with a speed, which without gravity adds energy.
World overlap()
{
    return solved({deck(dead), body_of(Box{{1, 1, 1}}, {0, 0.48, 0}, dead),
                   body_of(Box{{1, 1, 1}}, {0.1, 1.46, 0.1}, dead)},
                  {0, 0, 0});
}

const std::vector<std::pair<std::string, std::function<World()>>> problems = {
    {"a ball hits a box on a spring", ball_on_a_spring},
    {"a block slides", sliding_block},
    {"a block slides down a slope", block_on_a_slope},
    {"a stack whose top slides", stack},
    {"boxes fall on a pile", pile},
    {"a heavy box falls on a light one", heavy_on_light},
    {"a ball rolls", [] { return wheel(Sphere{0.2}); }},
    {"a cylinder rolls",
     [] {
         return wheel(Cylinder{0.2, 0.5});
     }},
    {"a capsule rolls",
     [] {
         return wheel(Capsule{0.2, 0.5});
     }},
    {"a torus rolls",
     [] {
         return wheel(Torus{0.15, 0.05});
     }},
    {"an ellipsoid rolls",
     [] {
         return wheel(Ellipsoid{{0.2, 0.2, 0.1}});
     }},
    {"balls bounce", bouncing_balls},
    {"billiard balls collide", billiards},
    {"a box bounces on its corners", [] { return tumbling_box(0.5); }},
    {"a box lands on its corners", [] { return tumbling_box(0); }},
    {"bodies meet in space",
     [] {
         return meeting({0, 0, 0});
     }},
    {"bodies meet in free fall",
     [] {
         return meeting({0, -g, 0});
     }},
    {"bodies that overlap part", overlap},
};

// The largest distance between the bodies of the ship and those on land, seen from their ground,
// at any time [m].
double largest_difference(const std::function<World()>& make, const Vector3d& V)
{
    World land = make(), sea = moving_at(V, make());
    double largest = 0;
    for (int n = 1; n <= steps; ++n) {
        step(land, h);
        step(sea, h);
        for (std::size_t i = 0; i < land.bodies.size(); ++i)
            if (!land.bodies[i].is_static)
                largest = std::max(largest, (sea.bodies[i].state.position - n * h * V -
                                             land.bodies[i].state.position)
                                                .norm());
    }
    return largest;
}

} // namespace

TEST_CASE("classics: all happens in a moving ship as on land", "[classics]")
{
    // What lands and rocks multiplies differences, which are errors of rounding or, for an
    // ellipsoid, of the search for its contact (`gap_tolerance` in convex_contact.cpp). All other
    // problems differ by less than 2e-9 m.
    for (const auto& [name, make] : problems)
        for (const Vector3d& V : {Vector3d(0, 0.1, 0), Vector3d(2, 0, -7)}) {
            CAPTURE(name, V);
            const bool rocks = name == "an ellipsoid rolls" || name == "a box lands on its corners";
            const double most = rocks ? 2e-8 : 2e-9;
            check_at_most(largest_difference(make, V), most, "difference [m]");
        }
}

TEST_CASE("classics: all happens at a thousand metres a second as on land", "[classics]")
{
    // The speeds have errors of 1e-13 m/s, a thousand times those on land, and so has the result.
    // Where the box on a spring lands on an edge, these errors decide after how many sweeps the
    // solver is content, and so the result has errors of the solver.
    for (const auto& [name, make] : problems) {
        for (const Vector3d& V :
             {Vector3d(0, 1000, 0), Vector3d(1000, 0, 0), Vector3d(-300, 500, 600)}) {
            CAPTURE(name, V);
            const bool lands = name == "a ball hits a box on a spring";
            check_at_most(largest_difference(make, V), lands ? 1e-5 : 2e-7, "difference [m]");
        }
    }
}

} // namespace galilean_boost
