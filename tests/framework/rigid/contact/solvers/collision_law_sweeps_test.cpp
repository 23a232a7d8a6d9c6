// SPDX-License-Identifier: MIT
#include "rigid/contact/solvers/collision_law_sweeps.hpp"

#include "framework/rigid/contact/solvers/sweep_laws.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr auto by_collision_law = [](ContactProblem& problem, std::span<const int> active) {
    return collision_law_sweeps(problem, active);
};
constexpr auto pile_by_collision_law = [](Pile& pile) {
    return collision_law_sweeps(pile, pile.active);
};

// A rod of 2 kg that stands askew on the ground and slides; its contact point is at the origin.
Body askew_rod()
{
    Body rod = ball_at({0.3, 0.4, 0.1}, 2, {1, -1, 0.5});
    rod.inverse_inertia = Vector3d(3, 5, 4).asDiagonal();
    return rod;
}

} // namespace

// The sweeps use the matrix K̃ instead of K (collision_law_sweeps.hpp). With K̃, the formula
// `collision_impulse` gives the same impulse at a contact as a visit by `resolve_simultaneously`.
TEST_CASE("collision law sweeps: n of them are n sweeps of resolve_simultaneously", "[rigid]")
{
    check_sweeps_are_those_of_the_formula(pile_by_collision_law);
}

TEST_CASE("collision law sweeps: impulses that are added act on the bodies", "[rigid]")
{
    check_added_impulses_act_on_the_bodies(pile_by_collision_law);
}

TEST_CASE("collision law sweeps: one sweep stops a single body", "[rigid]")
{
    check_progress_of_a_single_contact(by_collision_law);
}

TEST_CASE("collision law sweeps: without approach or contacts nothing changes", "[rigid]")
{
    check_sweeps_without_work(by_collision_law);
}

TEST_CASE("collision law sweeps: a body sticks or slides by Coulomb's law", "[rigid]")
{
    // A body of 3 kg touches the ground with its center of mass. It sticks as long as friction can
    // stop it; otherwise |j_T| = μ jₙ, against the sliding.
    const auto impulse = [](const Vector3d& velocity, double friction) {
        HandMade problem;
        const int ball = problem.add(ball_at({0, 0, 0}, 3, velocity));
        problem.touch(ball, 0, {0, 0, 0}).friction = friction;
        const std::vector<int> active = {0};
        const std::unique_ptr<Sweeps> sweeps = collision_law_sweeps(problem, active);
        std::vector<Vector3d> steps(1);
        sweeps->sweep(steps);
        sweeps->finish();
        return problem.contacts[0].contact_impulse;
    };
    CHECK_THAT(impulse({0.1, -1, 0.2}, 0.5), IsClose(Vector3d(-0.3, 3, -0.6), Rounding(8)));
    CHECK_THAT(impulse({4, -1, 3}, 0.5), IsClose(Vector3d(-1.2, 3, -0.9), Rounding(8)));
    CHECK_THAT(impulse({4, -1, 3}, 0), IsClose(Vector3d(0, 3, 0), Rounding(8)));
    CHECK(impulse({4, 1, 3}, 0.5) == Vector3d::Zero());
}

TEST_CASE("collision law sweeps: the fixed point obeys the laws of the contact with K", "[rigid]")
{
    for (const double friction : {0.0, 0.2, 5.0}) {
        CAPTURE(friction);
        HandMade problem;
        const int rod = problem.add(askew_rod());
        ContactConstraint& c = problem.touch(rod, 0, {0, 0, 0});
        c.friction = friction;
        c.target_speed = -0.25;
        const std::vector<int> active = {0};
        const std::unique_ptr<Sweeps> sweeps = collision_law_sweeps(problem, active);
        std::vector<Vector3d> steps(1);
        for (int i = 0; i < 400; ++i)
            sweeps->sweep(steps);
        sweeps->finish();
        const Vector3d v = problem.velocity_at(c, c.point), j = c.contact_impulse;
        CHECK_THAT(v.y(), IsClose(-0.25, Rounding(64, 2)));
        const Vector3d v_T(v.x(), 0, v.z()), j_T(j.x(), 0, j.z());
        if (friction > 1) { // it sticks
            CHECK_THAT(v_T, IsClose(Vector3d(0, 0, 0), Rounding(64, 2)));
            CHECK(j_T.norm() < friction * j.y());
        } else { // it slides, and friction is opposite to the velocity at the end
            REQUIRE(v_T.norm() > 0.1);
            CHECK_THAT(j_T,
                       IsClose(Vector3d(-friction * j.y() * v_T.normalized()), Rounding(256, 4)));
        }
    }
}
