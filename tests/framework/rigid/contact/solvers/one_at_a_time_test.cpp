// SPDX-License-Identifier: MIT
#include "rigid/contact/solvers/one_at_a_time.hpp"

#include "formulas/contact.hpp"
#include "framework/rigid/contact/hand_made.hpp"
#include "rigid/contact/local_island.hpp"

#include <numeric>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double speed_of_fall = g * 0.01; // by the gravity of one step [m/s]

// Balls of these masses on top of each other, with the velocity of their fall in this step.
struct Tower : HandMade {
    std::vector<int> active;

    explicit Tower(const std::vector<double>& masses)
    {
        for (std::size_t i = 0; i < masses.size(); ++i) {
            const double y = static_cast<double>(i);
            const int ball = add(ball_at({0, y + 0.5, 0}, masses[i], {0, -speed_of_fall, 0}));
            touch(ball, ball - 1, {0, y, 0});
        }
        active.resize(masses.size());
        std::iota(active.begin(), active.end(), 0);
    }

    double fastest() const
    {
        double speed = 0;
        for (const Body& body : bodies)
            speed = std::max(speed, body.velocity.norm() + body.angular_velocity.norm());
        return speed;
    }
};

} // namespace

TEST_CASE("one at a time: balls that meet move on together with their momentum", "[rigid]")
{
    HandMade problem;
    problem.add(ball_at({-0.5, 0, 0}, 1, {2, 0, 0}));
    problem.add(ball_at({0.5, 0, 0}, 3, {-1, 1, 0}));
    problem.touch(1, 2, {0, 0, 0}, {-1, 0, 0});
    const std::vector<int> active = {0};
    resolve_one_at_a_time(problem, active, false);
    // The momentum along x, 1·2 - 3·1 = -1 kg m/s, is shared by 4 kg. Across x nothing changes.
    CHECK_THAT(problem.bodies[1].velocity, IsClose(Vector3d(-0.25, 0, 0), Rounding(32, 2)));
    CHECK_THAT(problem.bodies[2].velocity, IsClose(Vector3d(-0.25, 1, 0), Rounding(32, 2)));
    CHECK_THAT(problem.contacts[0].contact_impulse, IsClose(Vector3d(-2.25, 0, 0), Rounding(32)));
    CHECK(problem.counted.contact_sweeps == 10);
}

TEST_CASE("one at a time: without shock propagation it is ten iterations of resolve_contacts",
          "[rigid]")
{
    Tower tower({3, 1, 2});
    tower.contacts[1].friction = 0.5;
    tower.bodies[2].velocity.x() = 0.3;
    const LocalIsland local = local_island(tower, tower.active);
    const ContactResult expected = resolve_contacts(local.bodies, local.contacts, 10);
    const Vector3d before = momentum(tower.bodies);
    resolve_one_at_a_time(tower, tower.active, false);
    for (int i = 0; i < 4; ++i)
        CHECK(moves_alike(tower.bodies[i], expected.bodies[i]));
    for (int k = 0; k < 3; ++k)
        CHECK(tower.contacts[k].contact_impulse == expected.impulses[k]);
    // Only the ground changes the momentum of the tower.
    CHECK_THAT(Vector3d(momentum(tower.bodies) - before),
               IsClose(tower.contacts[0].contact_impulse, Rounding(64, 1)));
}

TEST_CASE("one at a time: shock propagation follows with the levels of what rests on what",
          "[rigid]")
{
    Tower tower({2, 2, 2});
    // A ball beside the second one pushes it along x, and so neither of them rests on the other.
    const int beside = tower.add(ball_at({1, 1.5, 0}, 2, {-1, 0, 0}));
    tower.touch(beside, 2, {0.5, 1.5, 0}, {1, 0, 0});
    tower.active.push_back(3);
    for (ContactConstraint& c : tower.contacts)
        c.friction = 0.5;
    const LocalIsland local = local_island(tower, tower.active);
    const ContactResult first = resolve_contacts(local.bodies, local.contacts, 40);
    const ContactResult expected =
        shock_propagation(first.bodies, local.contacts, {0, 1, 2, 3, 1}, 10);
    resolve_one_at_a_time(tower, tower.active, true);
    // Ten iterations were not enough, forty were, and ten iterations of shock propagation followed.
    REQUIRE(tower.counted.contact_sweeps == 10 + 40 + 10);
    for (int i = 0; i < 5; ++i)
        CHECK(moves_alike(tower.bodies[i], expected.bodies[i]));
    for (int k = 0; k < 4; ++k)
        CHECK(tower.contacts[k].contact_impulse ==
              Vector3d(first.impulses[k] + expected.impulses[k]));
}

TEST_CASE("one at a time: shock propagation holds a thousand times its mass on a ball", "[rigid]")
{
    for (const bool shock : {false, true}) {
        CAPTURE(shock);
        Tower tower({1, 1, 1000});
        resolve_one_at_a_time(tower, tower.active, shock);
        if (!shock) {
            CHECK(tower.fastest() > 0.1 * speed_of_fall); // the load is too heavy for ten sweeps
            continue;
        }
        CHECK_THAT(tower.fastest(), IsClose(0.0, Rounding(64, speed_of_fall)));
        CHECK(tower.counted.contact_sweeps > 20); // ten before it were not enough
    }
}

TEST_CASE("one at a time: a ball on the ground is carried by its weight", "[rigid]")
{
    for (const bool shock : {false, true}) {
        CAPTURE(shock);
        Tower tower({2});
        tower.contacts[0].friction = 0.5;
        resolve_one_at_a_time(tower, tower.active, shock);
        CHECK_THAT(tower.contacts[0].contact_impulse,
                   IsClose(Vector3d(0, 2 * speed_of_fall, 0), Rounding(32)));
        CHECK_THAT(tower.fastest(), IsClose(0.0, Rounding(32, speed_of_fall)));
        CHECK(moves_alike(tower.bodies[0], Body()));
    }
}
