// SPDX-License-Identifier: MIT
// Contacts of nodes of which a handle prescribes some coordinates: plane strain, a guide.
#include "deformable/contact/held_axes.hpp"
#include "rigid/bodies/mass.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

namespace held_axes_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::array integrators = {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step};

// A block whose nodes are all held along these axes.
Deformable block_with_held(const std::array<bool, 3>& axes, NodeIntegrator integrator,
                           const Vector3d& center)
{
    SolidMaterial material = soft_material();
    material.damping = 0.01;
    Deformable block = make_deformable("block", block_tetrahedra({0.4, 0.2, 0.4}, {4, 2, 4}),
                                       material, Matrix3d::Identity(), center);
    block.integrator = integrator;
    Handle handle;
    for (int i = 0; i < static_cast<int>(block.positions.size()); ++i)
        handle.nodes.push_back(i);
    handle.axes = axes;
    block.handles.push_back(handle);
    return block;
}

DeformableWorld on_floor(Deformable block, double friction)
{
    block.material.surface.friction = friction;
    DeformableWorld world = world_of(std::move(block));
    world.rigid.settings.gravity = {0, -9.81, 0};
    add_floor(world);
    world.rigid.bodies[0].material.friction = friction;
    return world;
}

double lowest(const Deformable& solid, const Vector3d& n)
{
    double distance = never;
    for (const Vector3d& x : solid.positions)
        distance = std::min(distance, n.dot(x));
    return distance;
}

} // namespace

TEST_CASE("held axes: a free normal is the part of the normal along free coordinates",
          "[deformable]")
{
    const Vector3d n = Vector3d(3, 4, 0) / 5;
    REQUIRE(free_normal({}, n)->m == n);
    REQUIRE(free_normal({{true, false, false}}, n)->m == Vector3d::UnitY());
    CHECK_THAT(free_normal({{true, false, false}}, n)->cosine, IsClose(0.8, Rounding(4)));
    REQUIRE(free_normal({{false, false, true}}, n)->m == n);
    REQUIRE_FALSE(free_normal({{true, true, false}}, n));
    REQUIRE_FALSE(free_normal({{true, true, true}}, n));
    REQUIRE_FALSE(free_normal({{false, true, false}}, Vector3d(0.05, 1, 0).normalized()));
}

TEST_CASE("held axes: a block lands on the floor whichever of its axes are held", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const std::array<bool, 3>& axes :
             {std::array{false, false, true}, {true, false, false}, {true, false, true}})
            for (const double friction : {0.0, 0.5}) {
                CAPTURE(static_cast<int>(integrator), axes, friction);
                DeformableWorld world =
                    on_floor(block_with_held(axes, integrator, {0, 0.3, 0}), friction);
                for (int i = 0; i < 180; ++i) {
                    step(world, 1.0 / 60);
                    REQUIRE(lowest(world.solids[0], Vector3d::UnitY()) > -0.02);
                }
                check_at_most(totals(world.solids[0]).kinetic_energy, 1e-5, "kinetic energy");
                CHECK_THAT(lowest(world.solids[0], Vector3d::UnitY()), IsClose(0.0, Order(1e-4)));
            }
}

TEST_CASE("held axes: in plane strain a block slides or sticks as friction says", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const double friction : {0.0, 0.2, 1.0}) {
            CAPTURE(static_cast<int>(integrator), friction);
            DeformableWorld world =
                on_floor(block_with_held({false, false, true}, integrator, {0, 0.1, 0}), friction);
            // The tangent of the slope is 0.546.
            world.rigid.settings.gravity = {9.81 * std::sin(0.5), -9.81 * std::cos(0.5), 0};
            run(world, 1.0 / 60, 60);
            const double x = totals(world.solids[0]).center_of_mass.x();
            const double a = 9.81 * (std::sin(0.5) - friction * std::cos(0.5));
            if (friction > 0.546)
                check_at_most(x, 0.02, "shift by leaning");
            else
                CHECK_THAT(x, IsClose(0.5 * a, Order(0.2 * a)));
        }
}

TEST_CASE("held axes: a block in a vertical guide is lifted by a slope that it is pushed along",
          "[deformable][unsanitized]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const double slope : {0.2, 0.7, 1.2}) { // [rad]
            CAPTURE(static_cast<int>(integrator), slope);
            const Vector3d n(-std::sin(slope), std::cos(slope), 0);
            Deformable block =
                block_with_held({true, false, true}, integrator,
                                {0, 0.1 / std::cos(slope) + 0.2 * std::tan(slope), 0});
            block.material.youngs_modulus = 1e6;
            block.material.drag = 20; // so that the start does not shake it for long [1/s]
            const double speed = 0.3;
            block.handles[0].path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                                     {2, Vector3d(2 * speed, 0, 0), Vector3d::Zero()}};
            DeformableWorld world = on_floor(std::move(block), 0);
            world.rigid.bodies[0].state.orientation = {std::cos(slope / 2),
                                                       Vector3d(0, 0, std::sin(slope / 2))};
            run(world, 1.0 / 120, 120);
            const double before = totals(world.solids[0]).center_of_mass.y();
            run(world, 1.0 / 120, 60);
            const double rise = totals(world.solids[0]).center_of_mass.y() - before;
            CHECK_THAT(rise, IsClose(0.5 * speed * std::tan(slope), Order(1e-3)));
            CHECK(lowest(world.solids[0], n) > -2e-3);
        }
}

TEST_CASE("held axes: a ball gives a block in plane strain its momentum along the plane",
          "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world =
            world_of(block_with_held({false, false, true}, integrator, Vector3d::Zero()));
        RigidBody ball;
        ball.name = "ball";
        ball.parts = {Part{Sphere{0.1}, Vector3d::Zero(), Quaternion{}, 1000}};
        set_mass_from_parts(ball);
        ball.state.position = {0.05, 0.25, 0.02};
        ball.state.velocity = {0.5, -3, 0};
        world.rigid.bodies.push_back(ball);
        const auto momentum = [&] {
            const Vector3d all =
                totals(world.solids[0]).momentum + ball.mass * world.rigid.bodies[0].state.velocity;
            return Vector3d(all.x(), all.y(), 0); // the handle takes the rest
        };
        const Vector3d before = momentum();
        run(world, 1.0 / 120, 60);
        CHECK(totals(world.solids[0]).momentum.norm() > 1);
        const bool is_explicit = integrator == NodeIntegrator::explicit_step;
        CHECK_THAT(momentum(),
                   IsClose(before, is_explicit ? Rounding(1000) : Order(1e-4 * before.norm())));
    }
}

} // namespace held_axes_test
