// SPDX-License-Identifier: MIT
// A rigid body that spins hits a soft solid off its center, with friction, and rebounds. Nothing
// else acts on the two, so their momentum and their moment of momentum stay (Newton, corollaries 3
// and 4), whatever happens between them.
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace glancing_blow {

namespace {

struct Momenta {
    Vector3d P, L; // about the origin [kg m/s, kg m²/s]
};

Momenta momenta_of(const DeformableWorld& world)
{
    const DeformableTotals solid = totals(world.solids[0]);
    const RigidBody& body = world.rigid.bodies[0];
    const Vector3d P = body.mass * body.state.velocity;
    return {solid.momentum + P,
            solid.angular_momentum + body.state.position.cross(P) + body.state.angular_momentum};
}

// @param moves  the velocity of both in world space, which changes nothing between them
DeformableWorld world_of_blow(const Shape& shape, const Vector3d& moves)
{
    SolidMaterial material = soft_material();
    material.youngs_modulus = 1e6;
    material.surface = {0, 0.5};
    Deformable solid = solid_of(block_tetrahedra({1, 0.4, 0.6}, {4, 2, 2}), material);
    solid.integrator = NodeIntegrator::explicit_step;
    for (Vector3d& v : solid.velocities)
        v = moves;
    DeformableWorld world = world_of(std::move(solid));
    world.rigid.settings.gravity.setZero();
    RigidBody body = body_of(shape, {0.3, 0.45, 0.1}, {0, 0.5});
    body.state.velocity = moves + Vector3d(-1, -4, 0.5);
    body.state.angular_momentum = body.mass * Vector3d(0.2, -0.1, 0.3);
    world.rigid.bodies = {body};
    return world;
}

} // namespace

TEST_CASE("classics: a glancing blow on a soft solid keeps the moment of momentum", "[classics]")
{
    // A node that a corner presses into the solid is moved out again, without a change of momentum.
    constexpr double rounding = 1e-9, moved_out = 2e-4; // [m]
    const auto check = [](double h, const Shape& shape, const Vector3d& moves, double arm) {
        CAPTURE(h, shape.index(), moves.transpose());
        DeformableWorld world = world_of_blow(shape, moves);
        const Momenta before = momenta_of(world);
        const RigidBody& body = world.rigid.bodies[0];
        const double P = body.mass * (body.state.velocity - moves).norm();
        run(world, h, static_cast<int>(std::lround(0.2 / h)));
        CHECK(body.state.velocity.y() - moves.y() > 0); // it has hit the solid
        const Momenta after = momenta_of(world);
        CHECK_THAT(after.P, IsClose(before.P, Rounding(1e5, P + before.P.norm())));
        CHECK_THAT(after.L, IsClose(before.L, Order(arm * P)));
    };
    for (const double h : {0.02, 0.01, 0.0025})
        for (const Vector3d& moves : {Vector3d(0, 0, 0), Vector3d(3, -2, 5)}) {
            check(h, Sphere{0.2}, moves, rounding);
            check(h, Box{{0.3, 0.4, 0.3}}, moves, moved_out);
        }
}

} // namespace glancing_blow
