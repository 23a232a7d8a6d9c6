// SPDX-License-Identifier: MIT
// What presses a rigid body on a soft block: other bodies on top of it, forces, springs. However it
// is pressed, the block sinks by F L/(E A) under the whole force F, and everything comes to rest.
#include "rigid/bodies/mass.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"
#include "support/sweep.hpp"

namespace loads_on_solids_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

struct Method {
    NodeIntegrator integrator;
    double h; // [s]
};
constexpr Method methods[] = {{NodeIntegrator::explicit_step, 0.01},
                              {NodeIntegrator::implicit_step, 0.02},
                              {NodeIntegrator::implicit_step, 0.01},
                              {NodeIntegrator::implicit_step, 0.0025}};
constexpr double g = 9.81, width = 0.5, height = 0.5;

// A block without lateral contraction on a smooth floor, which gravity does not pull at.
DeformableWorld block_on_floor(NodeIntegrator integrator)
{
    SolidMaterial material = soft_material();
    material.poisson_ratio = 0;
    material.density = 100;
    material.damping = 0.02;
    material.surface = {0, 0.5};
    Deformable block = make_deformable("block", block_tetrahedra({width, height, width}, {2, 2, 2}),
                                       material, Matrix3d::Identity(), Vector3d(0, height / 2, 0));
    block.integrator = integrator;
    DeformableWorld world = world_of(block);
    world.rigid.settings.gravity = {0, -g, 0};
    add_floor(world);
    world.rigid.bodies[0].material.friction = 0;
    return world;
}

// A flat box, wider than the block.
RigidBody plate(double mass, double y)
{
    RigidBody body;
    body.name = "plate";
    body.material = {0, 0.5};
    body.parts = {Part{Box{{0.7, 0.1, 0.7}}, Vector3d::Zero(), Quaternion{}, mass / 0.049}};
    set_mass_from_parts(body);
    body.state.position = {0, y, 0};
    return body;
}

// How far the block sinks under a force, with its own weight [m].
double sinking(double force)
{
    const double own = 100 * width * width * height * g / 2;
    return (force + own) * height / (soft_material().youngs_modulus * width * width);
}

// The depth of the lowest plate below the upper face of the block at rest [m].
double depth(const DeformableWorld& world)
{
    return height + 0.05 - world.rigid.bodies[1].state.position.y();
}

double fastest(const DeformableWorld& world)
{
    double speed = 0;
    for (const RigidBody& body : world.rigid.bodies)
        speed = std::max(speed, body.state.velocity.norm());
    return speed;
}

void check_at_rest(const DeformableWorld& world, double force)
{
    CHECK_THAT(depth(world), IsClose(sinking(force), Order(0.01 * sinking(force))));
    check_at_most(fastest(world), 2e-3, "speed [m/s]");
}

} // namespace

TEST_CASE("loads: a solid carries a stack whatever its masses are", "[deformable][unsanitized]")
{
    Sweep sweep;
    for (const auto& [integrator, h] : methods)
        for (const std::vector<double>& masses :
             {std::vector<double>{20.0}, {10, 10}, {2, 18}, {0.2, 19.8}, {18, 2}, {1, 9, 10}}) {
            if (!sweep.takes_next()) continue;
            CAPTURE(integrator, h, masses);
            DeformableWorld world = block_on_floor(integrator);
            double y = height + 0.05;
            for (const double mass : masses) {
                world.rigid.bodies.push_back(plate(mass, y));
                y += 0.1;
            }
            run(world, h, static_cast<int>(3 / h));
            check_at_rest(world, 20 * g);
        }
}

TEST_CASE("loads: a force and a spring press a body on a solid as its weight does", "[deformable]")
{
    Sweep sweep;
    for (const auto& [integrator, h] : methods)
        for (const double mass : {1.0, 10.0, 100.0})
            for (const bool by_spring : {false, true}) {
                if (!sweep.takes_next()) continue;
                CAPTURE(integrator, h, mass, by_spring);
                DeformableWorld world = block_on_floor(integrator);
                world.rigid.bodies.push_back(plate(mass, height + 0.05));
                const double force = 100;
                if (by_spring) // 1 m long, and soft, so that its force hardly changes
                    world.rigid.springs.push_back(
                        {1, -1, {0, 0, 0}, {0, -1e3 + height + 0.05, 0}, 0.1, 0, 0});
                else
                    world.rigid.forces.push_back({1, {0, -force, 0}});
                run(world, h, static_cast<int>(3 / h));
                check_at_rest(world, mass * g + force);
                REQUIRE(world.rigid.forces.size() == (by_spring ? 0 : 1));
            }
}

TEST_CASE("loads: a force along a solid below friction does not make a body creep", "[deformable]")
{
    for (const double h : {0.02, 0.01, 0.0025}) {
        CAPTURE(h);
        DeformableWorld world = block_on_floor(NodeIntegrator::implicit_step);
        world.rigid.bodies[0].material.friction = 0.5;
        world.rigid.bodies.push_back(plate(20, height + 0.05));
        world.rigid.forces.push_back({1, {20, 0, 0}});
        run(world, h, static_cast<int>(3 / h));
        const double x = world.rigid.bodies[1].state.position.x();
        run(world, h, static_cast<int>(1 / h));
        check_at_most(std::abs(world.rigid.bodies[1].state.position.x() - x), 1e-5, "creep [m]");
    }
}

TEST_CASE("loads: a light box between the floor and a heavy solid keeps its place", "[deformable]")
{
    for (const auto& [integrator, h] : methods)
        for (const double mass : {2.0, 20.0}) {
            CAPTURE(integrator, h, mass);
            DeformableWorld world = block_on_floor(integrator);
            world.solids[0] = make_deformable(
                "heavy", block_tetrahedra({width, height, width}, {2, 2, 2}), soft_material(),
                Matrix3d::Identity(), Vector3d(0, 0.1 + height / 2, 0));
            world.solids[0].integrator = integrator;
            world.solids[0].material.damping = 0.02;
            world.rigid.bodies.push_back(plate(mass, 0.05));
            run(world, h, static_cast<int>(2 / h));
            CHECK_THAT(world.rigid.bodies[1].state.position.y(), IsClose(0.05, Order(1e-4)));
            for (const Vector3d& x : world.solids[0].positions)
                REQUIRE(x.y() > 0.1 - 5e-3);
        }
}

TEST_CASE("loads: nodes that a handle holds carry bodies and push them", "[deformable]")
{
    for (const auto& [integrator, h] : methods)
        for (const double speed : {0.0, 0.2}) { // upwards [m/s]
            CAPTURE(integrator, h, speed);
            DeformableWorld world = block_on_floor(integrator);
            Handle all;
            for (int i = 0; i < static_cast<int>(world.solids[0].positions.size()); ++i)
                all.nodes.push_back(i);
            all.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                        {10, Vector3d(0, 10 * speed, 0), Vector3d::Zero()}};
            world.solids[0].handles.push_back(all);
            world.rigid.bodies.push_back(plate(5, height + 0.06));
            run(world, h, static_cast<int>(2 / h));
            const double top = height + speed * world.rigid.time;
            CHECK_THAT(world.rigid.bodies[1].state.position.y(), IsClose(top + 0.05, Order(1e-3)));
            check_at_most(world.rigid.bodies[1].state.angular_momentum.norm(), 1e-3, "turning");
        }
}

TEST_CASE("loads: a beam without friction lies still on two round posts for long",
          "[deformable][unsanitized]")
{
    for (const double h : {0.02, 0.01, 0.005})
        for (const double damping : {0.0, 0.02}) {
            CAPTURE(h, damping);
            SolidMaterial material = soft_material();
            material.youngs_modulus = 1e7;
            material.damping = damping;
            DeformableWorld world =
                world_of(make_deformable("beam", block_tetrahedra({2, 0.2, 0.2}, {20, 2, 2}),
                                         material, Matrix3d::Identity(), Vector3d::Zero()));
            world.rigid.settings.gravity = {0, -g, 0};
            for (const double x : {-0.8, 0.8}) {
                RigidBody post;
                post.name = "post";
                post.is_static = true;
                post.parts = {Part{Capsule{0.1, 1}, Vector3d::Zero(), Quaternion{}, 1000}};
                post.state.position = {x, -0.2, 0};
                post.state.orientation = {std::sqrt(0.5), {std::sqrt(0.5), 0, 0}};
                world.rigid.bodies.push_back(post);
            }
            run(world, h, static_cast<int>(8 / h)); // throws if a number is not finite
            for (const Vector3d& v : world.solids[0].velocities)
                REQUIRE(v.norm() < 1e-2);
        }
}

} // namespace loads_on_solids_test
