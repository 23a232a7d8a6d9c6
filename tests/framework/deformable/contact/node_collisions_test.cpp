// SPDX-License-Identifier: MIT
#include "deformable/motion/stable_step.hpp"
#include "rigid/bodies/mass.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::array integrators = {NodeIntegrator::explicit_step, NodeIntegrator::implicit_step};

double lowest(const Deformable& solid)
{
    double y = never;
    for (const Vector3d& x : solid.positions)
        y = std::min(y, x.y());
    return y;
}

DeformableWorld block_above_floor(NodeIntegrator integrator, double height)
{
    SolidMaterial material = soft_material();
    material.damping = 0.01;
    material.surface = {0, 0.5};
    Deformable block =
        make_deformable("block", block_tetrahedra({0.4, 0.2, 0.4}, {4, 2, 4}), material,
                        Matrix3d::Identity(), Vector3d(0, 0.1 + height, 0));
    block.integrator = integrator;
    DeformableWorld world = world_of(block);
    world.rigid.settings.gravity = {0, -9.81, 0};
    add_floor(world);
    return world;
}

RigidBody ball(double radius, const Vector3d& position, const Vector3d& velocity)
{
    RigidBody body;
    body.name = "ball";
    body.parts = {Part{Sphere{radius}, Vector3d::Zero(), Quaternion{}, 1000}};
    set_mass_from_parts(body);
    body.state.position = position;
    body.state.velocity = velocity;
    return body;
}

} // namespace

TEST_CASE("contact: a block lands on the floor and rests there", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world = block_above_floor(integrator, 0.3);
        for (int i = 0; i < 180; ++i) {
            step(world, 1.0 / 60);
            REQUIRE(lowest(world.solids[0]) > -0.02);
        }
        const DeformableTotals sum = totals(world.solids[0]);
        check_at_most(sum.kinetic_energy, 1e-5, "kinetic energy");
        CHECK_THAT(lowest(world.solids[0]), IsClose(0.0, Order(1e-4)));
        // The weight lowers the center of mass of a column by ρ g H² / (3 E) = 1.3 mm.
        CHECK_THAT(sum.center_of_mass.y(), IsClose(0.0985, Order(1.5e-3)));
        CHECK(world.rigid.counters.node_impulses > 0);
    }
}

TEST_CASE("contact: on a slope a block slides or sticks as friction says", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const double friction : {0.2, 1.0}) {
            CAPTURE(friction);
            DeformableWorld world = block_above_floor(integrator, 0.0);
            // The tangent of the slope is 0.546.
            world.rigid.settings.gravity = {9.81 * std::sin(0.5), -9.81 * std::cos(0.5), 0};
            world.solids[0].material.surface.friction = friction;
            world.rigid.bodies[0].material.friction = friction;
            run(world, 1.0 / 60, 60);
            const double x = totals(world.solids[0]).center_of_mass.x();
            const double a = 9.81 * (std::sin(0.5) - friction * std::cos(0.5));
            if (friction > 0.546)
                check_at_most(x, 0.02, "shift by leaning");
            else
                CHECK_THAT(x, IsClose(0.5 * a, Order(0.2 * a)));
        }
}

TEST_CASE("contact: a ball and a block give each other the same impulse", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world = block_above_floor(integrator, 0);
        world.rigid.settings.gravity.setZero();
        world.rigid.bodies.clear();
        world.rigid.bodies.push_back(ball(0.1, {0.05, 0.35, 0.02}, {0.5, -3, 0}));
        const RigidBody& b = world.rigid.bodies[0];
        const auto momentum = [&] {
            return Vector3d(totals(world.solids[0]).momentum + b.mass * b.state.velocity);
        };
        const Vector3d before = momentum();
        double speed = 0;
        for (int i = 0; i < 60; ++i) {
            step(world, 1.0 / 120);
            speed = std::max(speed, totals(world.solids[0]).momentum.norm());
        }
        CHECK(b.state.velocity.y() > -1); // it rebounded, or nearly stopped
        CHECK(speed > 1);
        const bool is_explicit = integrator == NodeIntegrator::explicit_step;
        CHECK_THAT(momentum(),
                   IsClose(before, is_explicit ? Rounding(1000) : Order(1e-4 * before.norm())));
    }
}

TEST_CASE("contact: a ball rests on a soft block", "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world = block_above_floor(integrator, 0);
        world.rigid.bodies.push_back(ball(0.1, {0, 0.31, 0}, Vector3d::Zero()));
        run(world, 1.0 / 60, 240);
        const RigidState& state = world.rigid.bodies[1].state;
        check_at_most(state.velocity.norm(), 0.05, "speed");
        CHECK(state.position.y() > 0.2);
        CHECK(state.position.y() < 0.31);
    }
}

TEST_CASE("contact: a block that starts deep in the floor comes out of it without a jump",
          "[deformable]")
{
    for (const NodeIntegrator integrator : integrators) {
        DeformableWorld world = block_above_floor(integrator, -0.05);
        double fastest = 0;
        for (int i = 0; i < 240; ++i) {
            step(world, 1.0 / 60);
            for (const Vector3d& v : world.solids[0].velocities)
                fastest = std::max(fastest, v.norm());
        }
        check_at_most(fastest, 1.5, "speed"); // as after a fall of 0.11 m, about twice the depth
        CHECK_THAT(lowest(world.solids[0]), IsClose(0.0, Order(1e-3)));
    }
}

namespace {

struct Bar {
    Vector3d size;
    std::array<int, 3> cells;
    double poisson_ratio, restitution;
};

// A bar that moves towards the floor with the speed 1 m/s, without gravity.
DeformableWorld bar_above_floor(const Bar& bar)
{
    SolidMaterial material = soft_material();
    material.youngs_modulus = 1e6;
    material.poisson_ratio = bar.poisson_ratio;
    material.surface = {bar.restitution, 0.5};
    Deformable solid = make_deformable("bar", block_tetrahedra(bar.size, bar.cells), material,
                                       Matrix3d::Identity(), {0, bar.size.y() / 2 + 0.01, 0});
    solid.integrator = NodeIntegrator::explicit_step;
    std::fill(solid.velocities.begin(), solid.velocities.end(), Vector3d(0, -1, 0));
    DeformableWorld world = world_of(solid);
    world.rigid.settings.gravity.setZero();
    add_floor(world);
    world.rigid.bodies[0].material.restitution = bar.restitution;
    return world;
}

// Does a step of one substep. Returns Σ m v₋·v₊ / 2 + U, the energy that symplectic Euler keeps in
// linear springs. U belongs to the positions before the step, and the velocities v₋ and v₊ to half
// a substep before and after these.
double energy_in_step(DeformableWorld& world, double h)
{
    const Deformable before = world.solids[0];
    step(world, h);
    double energy = totals(before).elastic_energy;
    for (std::size_t i = 0; i < before.velocities.size(); ++i)
        energy += before.masses[i] / 2 * before.velocities[i].dot(world.solids[0].velocities[i]);
    return energy;
}

} // namespace

TEST_CASE("contact: a bounce of nodes gives a solid no energy however long its substeps are",
          "[deformable]")
{
    const std::pair<Vector3d, std::array<int, 3>> shapes[] = {{{0.1, 1, 0.1}, {1, 20, 1}},
                                                              {{0.1, 1, 0.1}, {1, 10, 1}},
                                                              {{0.2, 0.5, 0.2}, {2, 10, 2}},
                                                              {{0.5, 0.1, 0.5}, {5, 1, 5}},
                                                              {{0.3, 0.3, 0.3}, {3, 3, 3}}};
    for (const auto& [size, cells] : shapes)
        for (const double poisson_ratio : {0.0, 0.3})
            for (const double restitution : {0.5, 0.9, 1.0})
                for (const double share : {0.9, 0.85, 0.7, 0.45, 0.2}) {
                    const Bar bar = {size, cells, poisson_ratio, restitution};
                    DeformableWorld world = bar_above_floor(bar);
                    const DeformableTotals start = totals(world.solids[0]);
                    const Elements elements(world.solids[0]);
                    const double h = share * stable_step(world.solids[0], elements);
                    INFO("cells " << cells[0] << " " << cells[1] << ", Poisson's ratio "
                                  << poisson_ratio << ", restitution " << restitution
                                  << ", share of the stable step " << share);
                    run(world, h, static_cast<int>(0.1 / h)); // sound goes 3 m meanwhile
                    CHECK(totals(world.solids[0]).momentum.y() > 0);
                    const double after = energy_in_step(world, h);
                    check_at_most(after, start.kinetic_energy, "energy after the bounce [J]");
                }
}

TEST_CASE("contact: a body that only a solid carries does not sink into it",
          "[deformable][unsanitized]")
{
    for (const NodeIntegrator integrator : integrators)
        for (const double density : {100.0, 4000.0})
            for (const double h : {1.0 / 30, 1.0 / 60, 1.0 / 240}) {
                CAPTURE(integrator, density, h);
                DeformableWorld world = block_above_floor(integrator, 0);
                RigidBody box;
                box.name = "box";
                box.parts = {Part{Box{{0.3, 0.1, 0.3}}, Vector3d::Zero(), Quaternion{}, density}};
                set_mass_from_parts(box);
                box.state.position = {0, 0.25, 0};
                world.rigid.bodies.push_back(box);
                run(world, h, static_cast<int>(3 / h));
                // Nine nodes are below the box, and some of them carry it.
                double top = 0;
                for (const Vector3d& x : world.solids[0].positions)
                    if (std::max(std::abs(x.x()), std::abs(x.z())) < 0.14)
                        top = std::max(top, x.y());
                const double lower_face = world.rigid.bodies[1].state.position.y() - 0.05;
                const bool is_explicit = integrator == NodeIntegrator::explicit_step;
                CHECK_THAT(lower_face, IsClose(top, Order(is_explicit ? 5e-4 : 2e-6)));
            }
}
