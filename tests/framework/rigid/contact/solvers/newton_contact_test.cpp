// SPDX-License-Identifier: MIT
#include "rigid/contact/solvers/newton_contact.hpp"

#include "framework/rigid/worlds.hpp"

#include <optional>

using namespace rigor;
using namespace rigor::testing;

namespace {

// The impulse of the ground on a body of 3 kg that arrives with a velocity and touches the ground
// with its center of mass; nothing if the method fails.
std::optional<Vector3d> impulse_on(const Vector3d& velocity, double friction,
                                   const Matrix3d& inverse_inertia = Matrix3d::Identity())
{
    ContactProblem problem;
    problem.bodies.resize(2);
    problem.bodies[1].inverse_mass = 1. / 3;
    problem.bodies[1].inverse_inertia = inverse_inertia;
    problem.bodies[1].velocity = velocity;
    ContactConstraint c;
    c.body1 = 1;
    c.body2 = 0;
    c.friction = friction;
    problem.set_impulse_matrix(c);
    problem.contacts.push_back(c);
    Island island;
    island.bodies = {1};
    island.pairs = {{0, 1}};
    const std::vector<int> active = {0};
    std::vector<Vector3d> impulses = {Vector3d::Zero()};
    if (!newton_impulses(problem, island, problem.bodies_of(island), active, impulses)) return {};
    return impulses[0];
}

} // namespace

TEST_CASE("newton contact: a body without a lever is stopped or slides by Coulomb's law", "[rigid]")
{
    // It sticks as long as friction can stop it: j = -M v.
    CHECK_THAT(impulse_on({0.1, -1, 0.2}, 0.5).value(),
               IsClose(Vector3d(-0.3, 3, -0.6), Order(1e-9)));
    // Otherwise |j_T| = μ jₙ, against the sliding.
    CHECK_THAT(impulse_on({4, -1, 3}, 0.5).value(), IsClose(Vector3d(-1.2, 3, -0.9), Order(1e-9)));
    CHECK_THAT(impulse_on({4, -1, 3}, 0).value(), IsClose(Vector3d(0, 3, 0), Order(1e-9)));
    // An axis about which the body cannot turn does not matter.
    CHECK_THAT(impulse_on({0.1, -1, 0.2}, 0.5, Vector3d(1, 0, 1).asDiagonal()).value(),
               IsClose(Vector3d(-0.3, 3, -0.6), Order(1e-9)));
    // A contact does not pull.
    CHECK_THAT(impulse_on({1, 2, 0}, 0.5).value(), IsClose(Vector3d(0, 0, 0), Order(1e-9)));
}

TEST_CASE("newton contact: a point mass is stopped or slides like any other body", "[rigid]")
{
    const Matrix3d none = Matrix3d::Zero();
    CHECK_THAT(impulse_on({0, -1, 0}, 0, none).value(), IsClose(Vector3d(0, 3, 0), Order(1e-9)));
    CHECK_THAT(impulse_on({0.1, -1, 0.2}, 0.5, none).value(),
               IsClose(Vector3d(-0.3, 3, -0.6), Order(1e-9)));
    CHECK_THAT(impulse_on({4, -1, 3}, 0.5, none).value(),
               IsClose(Vector3d(-1.2, 3, -0.9), Order(1e-9)));
    CHECK_THAT(impulse_on({1, 2, 0}, 0.5, none).value(), IsClose(Vector3d(0, 0, 0), Order(1e-9)));
}
