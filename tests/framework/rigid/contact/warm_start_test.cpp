// SPDX-License-Identifier: MIT
#include "framework/rigid/worlds.hpp"
#include "rigid/contact/warm_start.hpp"

namespace warm_start_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 1.0 / 60; // [s]

} // namespace

TEST_CASE("warm start: a contact that carries nothing leaves its neighbour's impulse alone",
          "[rigid]")
{
    World world = world_of({fixed(Plane{}, {0, 0.5}), body_of(Box{{1, 1, 1}}, {0, 0.5, 0})});
    const Vector3d loaded(0.5, 0, 0.5), empty(0.48, 0, 0.5), force(0, -7, 0);
    world.memory.warm_contacts = {{0, 1, loaded, force}};
    std::vector<ContactConstraint> contacts(2);
    for (ContactConstraint& c : contacts) {
        c.body1 = 0;
        c.body2 = 1;
        c.normal = {0, -1, 0};
        c.radius = 1;
    }
    for (const bool is_first : {true, false}) { // whichever contact comes first
        CAPTURE(is_first);
        contacts[0].point = is_first ? empty : loaded;
        contacts[1].point = is_first ? loaded : empty;
        contacts[0].initial_impulse = contacts[1].initial_impulse = Vector3d::Zero();
        const std::vector<ContactPair> pairs = {{0, 2}};
        const std::vector<Pose> poses = {{}, {Matrix3d::Identity(), {0, 0.5, 0}}};
        CHECK(start_warm(world.memory.warm_contacts, poses, h, pairs, contacts) == 1);
        CHECK(contacts[is_first].initial_impulse == h * force);
        CHECK(contacts[!is_first].initial_impulse == Vector3d::Zero());
    }
}

TEST_CASE("warm start: a step that took no time leaves no impulses behind", "[rigid]")
{
    ContactConstraint c;
    c.body1 = 1;
    c.body2 = 0;
    c.point = {0, 1, 0};
    c.contact_impulse = {0, 3, 0};
    const std::vector<ContactConstraint> contacts = {c};
    const std::vector<Pose> poses = {{}, {Matrix3d::Identity(), {0, 0.5, 0}}};
    const std::vector<WarmContact> warm = warm_contacts(poses, contacts, 0.5);
    REQUIRE(warm.size() == 1);
    CHECK(warm[0].point == Vector3d(0, 0.5, 0));
    CHECK(warm[0].mean_force == Vector3d(0, 6, 0));
    CHECK(warm_contacts(poses, contacts, 0).empty());
}

} // namespace warm_start_test
