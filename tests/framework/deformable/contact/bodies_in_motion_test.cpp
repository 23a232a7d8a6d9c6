// SPDX-License-Identifier: MIT
// Rigid bodies that solids push and that also move, hang on stiff springs or stand on posts: they
// get no more energy and speed than the motion around them has.
#include "rigid/bodies/mass.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

namespace bodies_in_motion_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::array integrators = {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step};
constexpr double h = 0.01; // [s]

RigidBody box(const char* name, const Vector3d& size, const Vector3d& X, double mass)
{
    RigidBody body;
    body.name = name;
    body.material = {0, 0.5};
    body.parts = {Part{Box{size}, Vector3d::Zero(), Quaternion{}, mass / size.prod()}};
    body.state.position = X;
    if (mass > 0)
        set_mass_from_parts(body);
    else
        body.is_static = true;
    return body;
}

Deformable block(const Vector3d& size, const Vector3d& X, NodeIntegrator integrator)
{
    SolidMaterial material = soft_material();
    material.damping = 0.01;
    material.surface = {0, 0.5};
    Deformable solid = make_deformable("block", block_tetrahedra(size, {2, 2, 2}), material,
                                       Matrix3d::Identity(), X);
    solid.integrator = integrator;
    return solid;
}

Handle all_nodes(const Deformable& solid)
{
    Handle handle;
    for (int i = 0; i < static_cast<int>(solid.positions.size()); ++i)
        handle.nodes.push_back(i);
    return handle;
}

// A plank that lies on two posts, above a solid.
DeformableWorld plank_on_posts(Deformable solid, double mass)
{
    DeformableWorld world = world_of(std::move(solid));
    world.rigid.settings.gravity = {0, -9.81, 0};
    for (const double x : {-0.6, 0.6})
        world.rigid.bodies.push_back(box("post", {0.2, 1, 0.4}, {x, 0.5, 0}, 0));
    world.rigid.bodies.push_back(box("plank", {1.4, 0.1, 0.4}, {0, 1.05, 0}, mass));
    return world;
}

} // namespace

TEST_CASE("in motion: a plank on posts that a solid hits from below does not gain energy",
          "[deformable]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const double mass : {0.1, 1.0, 10.0}) {
            CAPTURE(integrator, mass);
            Deformable solid = block({0.4, 0.4, 0.4}, {0, 0.7, 0}, integrator);
            const double speed = 4;
            std::fill(solid.velocities.begin(), solid.velocities.end(), Vector3d(0, speed, 0));
            const double moving = totals(solid).kinetic_energy;
            DeformableWorld world = plank_on_posts(std::move(solid), mass);
            double fastest = 0;
            for (int i = 0; i < 60; ++i) {
                step(world, h);
                fastest = std::max(fastest, world.rigid.bodies[2].state.velocity.norm());
            }
            CHECK(fastest > 0.5); // it was hit
            check_at_most(0.5 * mass * fastest * fastest, moving, "kinetic energy [J]");
            check_at_most(fastest, 2.2 * speed, "speed [m/s]");
        }
}

TEST_CASE("in motion: nodes that a handle moves lift a table off its posts", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const double mass : {0.1, 10.0}) {
            CAPTURE(integrator, mass);
            Deformable solid = block({0.4, 0.2, 0.4}, {0, 0.85, 0}, integrator);
            Handle handle = all_nodes(solid);
            handle.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                           {2, Vector3d(0, 0.4, 0), Vector3d::Zero()}};
            solid.handles.push_back(handle);
            DeformableWorld world = plank_on_posts(std::move(solid), mass);
            double fastest = 0;
            for (int i = 0; i < 200; ++i) {
                step(world, h);
                fastest = std::max(fastest, world.rigid.bodies[2].state.velocity.norm());
            }
            check_at_most(fastest, 1, "speed [m/s]"); // the fork rises with 0.2 m/s
            CHECK_THAT(world.rigid.bodies[2].state.position.y(), IsClose(1.4, Order(0.01)));
        }
}

TEST_CASE("in motion: a stiff spring on a body that a solid carries stays stable", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const double omega_h : {0.5, 2.0, 8.0, 30.0}) {
            CAPTURE(integrator, omega_h);
            DeformableWorld world = world_of(block({0.5, 0.5, 0.5}, {0, 0.25, 0}, integrator));
            world.rigid.settings.gravity = {0, -9.81, 0};
            add_floor(world);
            world.rigid.bodies.push_back(box("plate", {0.7, 0.1, 0.7}, {0, 0.55, 0}, 10));
            const double k = 10 * omega_h * omega_h / (h * h);
            world.rigid.springs.push_back({1, -1, {0, 0, 0}, {0, 2.55, 0}, k, 0, 2.0});
            double highest = 0, lowest = 1;
            for (int i = 0; i < 200; ++i) {
                step(world, h);
                highest = std::max(highest, world.rigid.bodies[1].state.position.y());
                lowest = std::min(lowest, world.rigid.bodies[1].state.position.y());
            }
            CHECK(highest < 0.6);
            CHECK(lowest > 0.45);
        }
}

TEST_CASE("in motion: a puck slides over a plate on a solid as over any plate", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        CAPTURE(integrator);
        DeformableWorld world = world_of(block({0.8, 0.4, 0.8}, {0, 0.2, 0}, integrator));
        world.rigid.settings.gravity = {0, -9.81, 0};
        add_floor(world);
        world.rigid.bodies.push_back(box("plate", {1, 0.1, 1}, {0, 0.45, 0}, 20));
        world.rigid.bodies.push_back(box("puck", {0.1, 0.02, 0.1}, {-0.3, 0.51, 0}, 0.1));
        for (RigidBody& body : world.rigid.bodies)
            body.material.friction = 0;
        run(world, h, 200); // until the plate rests
        const double x = world.rigid.bodies[2].state.position.x();
        world.rigid.bodies[2].state.velocity.x() = 0.5;
        run(world, h, 80);
        CHECK_THAT(world.rigid.bodies[2].state.position.x() - x, IsClose(0.4, Order(0.01)));
    }
}

TEST_CASE("in motion: a body that can turn about one axis only is pushed by a solid",
          "[deformable]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(0.3, 0.2, 0.9), {1, 1, 1}}) {
            CAPTURE(integrator, axis);
            DeformableWorld world = world_of(block({0.5, 0.5, 0.5}, {0, 0.25, 0}, integrator));
            world.rigid.settings.gravity = {0, -9.81, 0};
            add_floor(world);
            RigidBody plate = box("plate", {0.7, 0.1, 0.7}, {0, 0.56, 0}, 10);
            let_turn_about(plate, axis.normalized());
            world.rigid.bodies.push_back(plate);
            run(world, h, 300);
            const double y = world.rigid.bodies[1].state.position.y();
            CHECK(y > 0.53);
            CHECK(y < 0.551);
        }
}

} // namespace bodies_in_motion_test
