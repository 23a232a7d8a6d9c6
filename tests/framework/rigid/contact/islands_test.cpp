// SPDX-License-Identifier: MIT
#include "rigid/contact/islands.hpp"

#include "framework/rigid/worlds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

ContactConstraint contact(int body1, int body2, double height, double gap)
{
    ContactConstraint c;
    c.body1 = body1;
    c.body2 = body2;
    c.point = {0, height, 0};
    c.gap = gap;
    return c;
}

// A stack of the bodies 1 and 2 on the ground (body 0), and beside it body 3 with the given gap to
// the ground [m].
struct Case {
    World world = world_of({fixed(Plane{}, {}), body_of(Sphere{0.5}, {0, 0.5, 0}),
                            body_of(Sphere{0.5}, {0, 1.5, 0}), body_of(Sphere{0.5}, {5, 0.6, 0})});
    ContactProblem problem;
    std::vector<ContactPair> pairs;

    explicit Case(double gap)
    {
        problem.time_step = 0.01;
        problem.settings = world.settings;
        problem.bodies.resize(world.bodies.size());
        for (const ContactConstraint& c : {contact(1, 2, 1, -0.01), contact(0, 1, 0, -0.01),
                                           contact(0, 1, 0.1, -0.01), contact(0, 3, 0, gap)})
            problem.contacts.push_back(c);
        pairs = pairs_of(problem.contacts);
        sort_by_height(problem, pairs);
    }
};

} // namespace

TEST_CASE("islands: a static body does not connect the bodies that touch it", "[rigid]")
{
    const Case both(-0.01);
    REQUIRE(both.pairs.size() == 3);
    CHECK(both.problem.contacts[both.pairs.back().first].point.y() == 1); // the highest comes last
    const std::vector<Island> islands = islands_of(both.world, both.problem, both.pairs);
    REQUIRE(islands.size() == 2);
    CHECK(islands[0].bodies == std::vector<int>{1, 2});
    CHECK(contact_count(islands[0].pairs) == 3);
    CHECK(islands[1].bodies == std::vector<int>{3});
}

TEST_CASE("islands: one in which nothing would penetrate is left out", "[rigid]")
{
    const Case one(0.01);
    const std::vector<Island> islands = islands_of(one.world, one.problem, one.pairs);
    REQUIRE(islands.size() == 1);
    CHECK(islands[0].bodies == std::vector<int>{1, 2});
}

TEST_CASE("islands: without the skip all bodies with contacts are one", "[rigid]")
{
    Case both(-0.01);
    both.world.settings.optimisations.islands = false;
    const std::vector<Island> islands = islands_of(both.world, both.problem, both.pairs);
    REQUIRE(islands.size() == 1);
    CHECK(islands[0].bodies == std::vector<int>{1, 2, 3});
}

TEST_CASE("islands: one whose gap a driven body that turns may close counts", "[rigid]")
{
    Case one(1e-5);
    Body& ground = one.problem.bodies[0];
    ground.position = {0, -2, 0}; // its point below body 3 is at the distance 2 m of its center
    CHECK(islands_of(one.world, one.problem, one.pairs).size() == 1);
    ground.angular_velocity = {0, 0, 0.3};
    CHECK(islands_of(one.world, one.problem, one.pairs).size() == 1);
    ground.angular_velocity = {0, 0, 0.4}; // (0.01 · 0.4)² · 2 m/2 = 1.6e-5 m
    CHECK(islands_of(one.world, one.problem, one.pairs).size() == 2);
}
