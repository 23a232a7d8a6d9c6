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
    world.memory.warm_contacts = {{0, 1, loaded, Vector3d(0.5, -0.5, 0.5), force}};
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
    CHECK(warm[0].point1 == Vector3d(0, 0.5, 0));
    CHECK(warm[0].point2 == Vector3d(0, 1, 0));
    CHECK(warm[0].mean_force == Vector3d(0, 6, 0));
    CHECK(warm_contacts(poses, contacts, 0).empty());
}

TEST_CASE("warm start: contacts are found again on either body", "[rigid]")
{
    // Body 1 has moved by 1 m: the contact has stayed on one of the bodies.
    const std::vector<Pose> poses = {{Matrix3d::Identity(), {1, 0, 0}}, {}};
    const Vector3d force(0, 7, 0);
    for (const double x : {0., 1.}) {
        CAPTURE(x);
        std::vector<ContactConstraint> contacts(1);
        contacts[0].body1 = 0;
        contacts[0].body2 = 1;
        contacts[0].point = {x, 0, 0};
        contacts[0].normal = {0, 1, 0};
        contacts[0].radius = 1;
        const std::vector<WarmContact> before = {{0, 1, Vector3d::Zero(), Vector3d::Zero(), force}};
        const std::vector<ContactPair> pairs = {{0, 1}};
        CHECK(start_warm(before, poses, h, pairs, contacts) == 1);
        CHECK(contacts[0].initial_impulse == h * force);
    }
}

TEST_CASE("warm start: the load of a face that slides is spread evenly", "[rigid]")
{
    // The friction is at its limit. The loads have the sum 8 N s and, about the middle, no moment
    // or one that the front contacts bear more of.
    const double mu = 0.5;
    const auto started = [&](std::array<double, 4> loads, double share_of_friction) {
        std::vector<ContactConstraint> contacts(4);
        std::vector<WarmContact> before;
        for (int i = 0; i < 4; ++i) {
            ContactConstraint& c = contacts[i];
            c.body1 = 1;
            c.body2 = 0;
            c.point = {i % 2 == 0 ? 1. : -1., 0, i < 2 ? 1. : -1.};
            c.normal = {0, 1, 0};
            c.radius = 1;
            c.friction = mu;
            const double j_n = loads[i] / h;
            if (j_n > 0)
                before.push_back({1, 0, c.point, c.point, {share_of_friction * mu * j_n, j_n, 0}});
        }
        const std::vector<ContactPair> pairs = {{0, 4}};
        start_warm(before, {{}, {}}, h, pairs, contacts);
        std::array<double, 4> result{};
        for (int i = 0; i < 4; ++i)
            result[i] = contacts[i].initial_impulse.y();
        return result;
    };
    const auto check = [](const std::array<double, 4>& found, const std::array<double, 4>& loads) {
        for (int i = 0; i < 4; ++i)
            CHECK_THAT(found[i], IsClose(loads[i], Rounding(64, 8)));
    };
    check(started({3, 1, 1, 3}, 1), {2, 2, 2, 2});
    check(started({4, 0, 0, 4}, 1), {2, 2, 2, 2});
    check(started({5, 1, 1, 1}, 1), {5, 1, 1, 1});   // (4, 2, 2, 0) would leave one without a load
    check(started({3, 2, 2, 1}, 1), {3, 2, 2, 1});   // already a linear function of the place
    check(started({3, 1, 1, 3}, 0.9), {3, 1, 1, 3}); // nothing slides
}

} // namespace warm_start_test
