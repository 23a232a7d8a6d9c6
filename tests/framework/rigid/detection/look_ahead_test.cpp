// SPDX-License-Identifier: MIT
// Shapes that come to an edge of a box: with what normal, and at what gap, they touch it.
#include "rigid/detection/look_ahead.hpp"

#include "framework/rigid/worlds.hpp"
#include "rigid/detection/narrow_phase.hpp"

#include <numbers>

namespace look_ahead_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double h = 0.01, r = 0.1; // time step [s], radius of the shapes [m]

// The contacts that a step finds between a body that moves and a box, whose top is at y = 0 and
// whose edge is at x = 0. The box lies at x > 0.
std::vector<Contact> contacts_of(RigidBody body, const Vector3d& V)
{
    body.state.velocity = V;
    const World world = world_of({fixed(Box{{1, 1, 1}}, {0, 0}, {0.5, -0.5, 0}), body});
    const std::vector<Pose> poses = {pose_of(world.bodies[0].state),
                                     pose_of(world.bodies[1].state)};
    std::vector<Contact> contacts;
    Counters counters;
    find_contacts(world, poses, 0, 1, 1, contacts, counters, h);
    for (Contact& c : contacts)
        c.normal = -c.normal; // from the box to the body
    return contacts;
}

// A cylinder or a capsule that lies along the edge of the box, at this distance before it.
std::vector<RigidBody> rollers(double distance, double height)
{
    const Quaternion q = turn({1, 0, 0}, std::numbers::pi / 2);
    const Vector3d X(-distance, height, 0);
    return {body_of(Cylinder{r, 0.4}, X, {}, q), body_of(Capsule{r, 0.4}, X, {}, q)};
}

} // namespace

TEST_CASE("look ahead: what rolls onto a box stays on its top", "[rigid]")
{
    for (const double distance : {0.001, 0.01, 0.019})
        for (const RigidBody& body : rollers(distance, r)) {
            CAPTURE(distance);
            const std::vector<Contact> contacts = contacts_of(body, {2, 0, 0}); // by 0.02 m
            CHECK_FALSE(contacts.empty());
            for (const Contact& c : contacts) {
                CHECK_THAT(c.normal, IsClose(Vector3d(0, 1, 0), Rounding(1e8)));
                CHECK_THAT(c.gap, IsClose(0.0, Order(1e-9)));
            }
        }
}

TEST_CASE("look ahead: what falls beside a box or runs into it meets its side", "[rigid]")
{
    for (const RigidBody& body : rollers(r + 0.005, -0.3))
        for (const Vector3d& V : {Vector3d(2, 0, 0), Vector3d(2, -3, 0)})
            for (const Contact& c : contacts_of(body, V)) {
                CHECK_THAT(c.normal, IsClose(Vector3d(-1, 0, 0), Rounding(1e8)));
                CHECK_THAT(c.gap, IsClose(0.005, Order(1e-9)));
            }
}

TEST_CASE("look ahead: what stands by its edge keeps the normal of the edge", "[rigid]")
{
    for (const RigidBody& body : rollers(0.01, std::sqrt(r * r - 0.01 * 0.01)))
        for (const Vector3d& V : {Vector3d(0, 0, 0), Vector3d(-2, 0, 0)})
            for (const Contact& c : contacts_of(body, V)) {
                CHECK_THAT(c.normal, IsClose(Vector3d(-0.1, std::sqrt(0.99), 0), Order(1e-6)));
                CHECK_THAT(c.gap, IsClose(0.0, Order(1e-9)));
            }
}

TEST_CASE("look ahead: a capsule over an edge is held at its end and at the edge", "[rigid]")
{
    const Quaternion q = turn({0, 0, 1}, std::numbers::pi / 2); // along x
    for (const double overhang : {0.03, 0.1, 0.17}) {
        CAPTURE(overhang);
        const std::vector<Contact> contacts =
            contacts_of(body_of(Capsule{r, 0.4}, {0.2 - overhang, r, 0}, {}, q), {0, 0, 0});
        double least = 1, most = 0;
        for (const Contact& c : contacts) {
            if (c.gap > 1e-9) continue;
            CHECK_THAT(c.normal, IsClose(Vector3d(0, 1, 0), Order(1e-6)));
            least = std::min(least, c.point.x());
            most = std::max(most, c.point.x());
        }
        CHECK_THAT(least, IsClose(0.0, Order(2e-4 * r)));
        CHECK_THAT(most, IsClose(0.4 - overhang, Rounding(16, 1)));
    }
}

} // namespace look_ahead_test
