// SPDX-License-Identifier: MIT
// Rigid bodies that solids push: which of them stand on something, and what the push does to them.
#include "deformable/contact/rigid_colliders.hpp"

#include "deformable/step/step.hpp"
#include "framework/rigid/integrators.hpp"
#include "rigid/bodies/mass.hpp"
#include "rigid/step/step.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 0.01; // [s]

// A box on a floor below a soft block, whose lower face is `gap` above the box.
DeformableWorld block_above_box(double edge, double gap)
{
    DeformableWorld world = world_of(
        make_deformable("block", block_tetrahedra(Vector3d::Constant(edge), {2, 2, 2}),
                        soft_material(), Matrix3d::Identity(), Vector3d(0, 1.5 * edge + gap, 0)));
    world.rigid.settings.gravity = {0, -9.81, 0};
    add_floor(world);
    const Material surface = {0, 0.5}; // a box that bounces would leave its place
    world.rigid.bodies[0].material = world.solids[0].material.surface = surface;
    RigidBody box;
    box.name = "box";
    box.material = surface;
    box.parts = {Part{Box{Vector3d::Constant(edge)}, Vector3d::Zero(), Quaternion{}, 1000}};
    box.state.position = {0, edge / 2, 0};
    set_mass_from_parts(box);
    world.rigid.bodies.push_back(box);
    return world;
}

} // namespace

TEST_CASE("deformable: a box that slept on a floor is not pressed into it when a solid wakes it")
{
    for (const double edge : {0.1, 0.5, 2.0})
        for (const double gap : {0.05, 0.2}) {
            DeformableWorld world = block_above_box(edge, edge * gap);
            while (!world.rigid.bodies[1].rest.is_asleep() && world.rigid.time < 2)
                step(world.rigid, h); // the solid does not fall meanwhile
            REQUIRE(world.rigid.bodies[1].rest.is_asleep());
            const double before = world.rigid.bodies[1].state.position.y();
            while (world.rigid.bodies[1].rest.is_asleep() && world.rigid.time < 4)
                step(world, h);
            REQUIRE_FALSE(world.rigid.bodies[1].rest.is_asleep());
            CAPTURE(edge, gap);
            const double fall = 0.5 * 9.81 * h * h;
            check_at_most(std::abs(world.rigid.bodies[1].state.position.y() - before), 0.1 * fall,
                          "the box moves");
        }
}

namespace {

// The height [m] at which a box without friction comes to rest on a soft block, whose lowest nodes
// are held.
double height_of_rest(Integrator integrator, double step_length)
{
    DeformableWorld world = block_above_box(0.5, 0);
    Deformable& block = world.solids[0];
    block.material.damping = 0.02;
    block.material.surface.friction = 0;
    Handle ground;
    double lowest = block.positions[0].y(), highest = lowest;
    for (const Vector3d& x : block.positions) {
        lowest = std::min(lowest, x.y());
        highest = std::max(highest, x.y());
    }
    for (int i = 0; i < static_cast<int>(block.positions.size()); ++i)
        if (block.positions[i].y() < lowest + 1e-9) ground.nodes.push_back(i);
    block.handles.push_back(ground);
    RigidBody& box = world.rigid.bodies[1];
    box.material.friction = 0;
    box.parts[0].shape = Box{{0.6, 0.5, 0.6}}; // wider than the block, so that no node leaves it
    set_mass_from_parts(box);
    box.state.position = {0, highest + 0.25, 0};
    world.rigid.settings.integrator = integrator;
    while (world.rigid.time < 4)
        step(world, step_length);
    return world.rigid.bodies[1].state.position.y();
}

} // namespace

TEST_CASE("deformable: a box on a soft block lies as deep by every integrator")
{
    for (const double step_length : {0.02, 0.01}) {
        const double expected = height_of_rest(Integrator::exact, step_length);
        for (const Integrator integrator : all_integrators) {
            CAPTURE(static_cast<int>(integrator), step_length);
            const double fall = 0.5 * 9.81 * step_length * step_length;
            check_at_most(std::abs(height_of_rest(integrator, step_length) - expected), 0.01 * fall,
                          "difference of the heights [m]");
        }
    }
}
