// SPDX-License-Identifier: MIT
#include "rigid/contact/local_island.hpp"

#include "framework/rigid/contact/hand_made.hpp"

#include <stdexcept>

using namespace rigor;
using namespace rigor::testing;

namespace {

// Bodies 1 … 5, of which body 3 is static. Contact 0 is between the bodies 1 and 4. It belongs to
// another island than contact 1, between 5 and 2, and contact 2, between 2 and 3.
struct Bodies : HandMade {
    const std::vector<int> active = {1, 2};

    Bodies()
    {
        for (int i = 1; i <= 5; ++i)
            add(i == 3 ? Body() : ball_at({0, 1.0 * i, 0}, i));
        touch(1, 4, {9, 0, 0});
        touch(5, 2, {0, 3, 0});
        touch(2, 3, {0, 1, 0});
        contacts[1].gap = -0.25;
        contacts[1].friction = 0.7;
        contacts[1].target_speed = -1.5;
        contacts[1].initial_impulse = {1, 2, 3};
    }
};

// The result that leaves everything as it was.
ContactResult unchanged(const LocalIsland& local)
{
    return {local.bodies, std::vector<Vector3d>(local.contacts.size(), Vector3d::Zero())};
}

} // namespace

TEST_CASE("local island: it has the bodies of the contacts and no others", "[rigid]")
{
    const Bodies all;
    const LocalIsland local = local_island(all, all.active);
    CHECK(local.indices == std::vector<int>{2, 3, 5}); // the static one too
    REQUIRE(local.bodies.size() == 3);
    CHECK(local.bodies[0].position.y() == 2);
    CHECK(local.bodies[1].is_static());
    CHECK(local.bodies[2].position.y() == 5);
    REQUIRE(local.contacts.size() == 2);
    CHECK(local.contacts[0].body1 == 2);
    CHECK(local.contacts[0].body2 == 0);
    CHECK(local.contacts[1].body1 == 0);
    CHECK(local.contacts[1].body2 == 1);
}

TEST_CASE("local island: a contact keeps its values and its depth is the negative gap", "[rigid]")
{
    const Bodies all;
    const BodyContact c = local_island(all, all.active).contacts[0];
    CHECK(c.point == Vector3d(0, 3, 0));
    CHECK(c.normal == Vector3d(0, 1, 0));
    CHECK(c.depth == 0.25);
    CHECK(c.friction == 0.7);
    CHECK(c.separation_speed == -1.5);
    CHECK(c.impulse == Vector3d(1, 2, 3));
}

TEST_CASE("local island: contacts come in the order of the active ones", "[rigid]")
{
    const Bodies all;
    const LocalIsland local = local_island(all, std::vector<int>{2, 1});
    CHECK(local.contacts[0].point == Vector3d(0, 1, 0));
    CHECK(local.contacts[1].point == Vector3d(0, 3, 0));
}

TEST_CASE("local island: depths that differ by rounding alone are equal", "[rigid]")
{
    Bodies all;
    all.contacts[2].gap = std::nextafter(-0.25, -1);
    const LocalIsland local = local_island(all, all.active);
    CHECK(local.contacts[0].depth == local.contacts[1].depth);
    all.contacts[2].gap = -0.2500001;
    CHECK(local_island(all, all.active).contacts[1].depth > 0.25);
}

TEST_CASE("local island: without contacts it is empty", "[rigid]")
{
    Bodies all;
    const LocalIsland local = local_island(all, {});
    CHECK(local.indices.empty());
    CHECK(local.bodies.empty());
    CHECK(local.contacts.empty());
    const std::vector<Body> before = all.bodies;
    take_result(all, local, {}, {}, "resolve_contacts");
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(moves_alike(all.bodies[i], before[i]));
}

TEST_CASE("local island: a result changes its own bodies and contacts", "[rigid]")
{
    Bodies all;
    const LocalIsland local = local_island(all, all.active);
    ContactResult result = unchanged(local);
    for (Body& body : result.bodies) {
        body.position = {7, 7, 7};
        body.velocity = {1, 0, 0};
        body.angular_velocity = {0, 1, 0};
        body.angular_momentum = {0, 0, 1};
    }
    result.impulses = {{4, 5, 6}, {7, 8, 9}};
    const std::vector<Body> before = all.bodies;
    take_result(all, local, all.active, result, "resolve_contacts");
    for (int i : {2, 5}) {
        CHECK(moves_alike(all.bodies[i], result.bodies[0]));
        CHECK(all.bodies[i].position == before[i].position); // an impulse moves nothing
    }
    for (int i : {0, 1, 3, 4}) // 3 is static
        CHECK(moves_alike(all.bodies[i], before[i]));
    CHECK(all.contacts[0].contact_impulse == Vector3d::Zero());
    CHECK(all.contacts[1].contact_impulse == Vector3d(4, 5, 6));
    CHECK(all.contacts[2].contact_impulse == Vector3d(7, 8, 9));
}

TEST_CASE("local island: a result of another size is refused by the name of its formula", "[rigid]")
{
    Bodies all;
    const LocalIsland local = local_island(all, all.active);
    const std::vector<Body> before = all.bodies;
    ContactResult longer = unchanged(local), shorter = unchanged(local);
    for (Body& body : longer.bodies)
        body.velocity = {1, 0, 0};
    longer.bodies.emplace_back();
    shorter.impulses.pop_back();
    CHECK_NOTHROW(check_size(local, unchanged(local), "resolve_contacts"));
    CHECK_THROWS_AS(check_size(local, longer, "resolve_contacts"), std::out_of_range);
    CHECK_THROWS_WITH(take_result(all, local, all.active, longer, "resolve_contacts"),
                      "resolve_contacts returned 4 bodies and 2 impulses for 3 bodies and 2 "
                      "contacts");
    CHECK_THROWS_WITH(take_result(all, local, all.active, shorter, "shock_propagation"),
                      "shock_propagation returned 3 bodies and 1 impulses for 3 bodies and 2 "
                      "contacts");
    for (std::size_t i = 0; i < before.size(); ++i)
        CHECK(moves_alike(all.bodies[i], before[i]));
}
