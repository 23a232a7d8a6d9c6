// SPDX-License-Identifier: MIT
// A5: contacts that are listed twice or are nearly equally deep, many of them, high friction, a
// static body that turns, and levels with gaps between them.
#include "contact_cases.hpp"
#include "formulas/contact.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

namespace contact_strata_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// A ball that falls with 1 m/s and slides with 7 m/s along x, so that it takes a friction
// impulse of 2 N s to stop the sliding of its lowest point.
ContactCase sliding_ball(double friction)
{
    return {{Body(), ball(1, {7, -1, 0})}, {touch(1, 0, 0.01, {0, 0, 0}, friction)}};
}

// The same ball on a kinematic body, which has no mass, but a velocity. Its surface moves as fast
// as the ball, so that the ball does not slide.
ContactCase ball_on_turntable(bool turns, bool table_is_first)
{
    ContactCase problem = sliding_ball(10);
    Body& ground = problem.bodies[0];
    ground.position = {0, 0, 7};
    if (turns)
        ground.angular_velocity = {0, -1, 0}; // ω × (x - X) = (7, 0, 0)
    else
        ground.velocity = {7, 0, 0};
    BodyContact& contact = problem.contacts[0];
    if (table_is_first) {
        std::swap(contact.body1, contact.body2);
        contact.normal = -contact.normal;
    }
    return problem;
}

// @param resolve  computes the ContactResult from a ContactCase
template <class Resolve> void check_turntables(const Resolve& resolve)
{
    for (const bool turns : {false, true})
        for (const bool table_is_first : {false, true}) {
            CAPTURE(turns, table_is_first);
            const ContactCase problem = ball_on_turntable(turns, table_is_first);
            const ContactResult result = resolve(problem);
            const Vector3d j = table_is_first ? -up : up;
            REQUIRE_THAT(result.impulses[0], IsClose(j, Rounding(64, 7)));
            REQUIRE_THAT(result.bodies[1].velocity, IsClose(Vector3d(7, 0, 0), Rounding(64)));
            REQUIRE_THAT(result.bodies[0].velocity, IsExactly(problem.bodies[0].velocity));
        }
}

} // namespace

TEST_CASE("contact: a contact that is listed twice is resolved twice", "[A5.2][contact]")
{
    // ε = -½ leaves half of the approach at each visit, and ε = 0 in the second iteration none
    ContactCase problem = stack({1});
    problem.contacts.push_back(problem.contacts[0]);
    const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, 2);
    REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(0.75 * up), Rounding(16)));
    REQUIRE_THAT(result.impulses[1], IsClose(Vector3d(0.25 * up), Rounding(16)));
}

TEST_CASE("contact: the deeper contact comes first however little deeper it is", "[A5.2][contact]")
{
    // the lower block stops before the upper one lands on it, if its contact comes first
    for (int power = 1; power <= 44; ++power) {
        CAPTURE(power);
        ContactCase problem = stack({1, 1});
        problem.contacts[0].depth = 0.5 + std::ldexp(1, -power);
        problem.contacts[1].depth = 0.5;
        std::swap(problem.contacts[0], problem.contacts[1]);
        const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, 1);
        REQUIRE_THAT(result.bodies[2].velocity, IsClose(Vector3d(-0.5 * up), Rounding(64, 1)));
    }
}

TEST_CASE("contact: a pile of many contacts is resolved whole", "[A5.2][contact]")
{
    ContactCase problem = {{Body()}, {}};
    for (int i = 1; i <= 3000; ++i) {
        problem.bodies.push_back(block(1, -up));
        problem.contacts.push_back(touch(i, 0, 1.0 / i));
    }
    const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, 1);
    for (int i = 1; i <= 3000; ++i)
        REQUIRE_THAT(result.impulses[i - 1], IsClose(up, Rounding(64)));
}

TEST_CASE("contact: all at once a pile of many contacts is resolved whole", "[A5.5][contact]")
{
    ContactCase problem = {{Body()}, {}};
    for (int i = 1; i <= 4000; ++i) {
        problem.bodies.push_back(block(1, -up));
        problem.contacts.push_back(touch(i, 0, 0.01));
    }
    const ContactResult result = resolve_simultaneously(problem.bodies, problem.contacts, 1);
    for (int i = 1; i <= 4000; ++i)
        REQUIRE_THAT(result.impulses[i - 1], IsClose(up, Rounding(64)));
}

TEST_CASE("contact: each of many iterations has its own restitution", "[A5.2][contact]")
{
    const ContactCase problem = rod_on_both_ends();
    for (const int n : {2, 10, 25, 60, 200}) {
        CAPTURE(n);
        const std::array<double, 2> sums = impulses_on_both_ends(n);
        const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, n);
        for (int i = 0; i < 2; ++i)
            REQUIRE_THAT(result.impulses[i],
                         IsClose(Vector3d(sums[i] * up), Rounding(32.0 * n + 64, 1)));
    }
}

TEST_CASE("contact: friction above 1 holds a ball", "[A5.2][contact]")
{
    for (const double friction : {1.5, 1.9, 2.5, 1e6}) {
        CAPTURE(friction);
        const ContactCase problem = sliding_ball(friction);
        const double held = std::min(friction, 2.0);
        REQUIRE_THAT(resolve_contacts(problem.bodies, problem.contacts, 1).impulses[0],
                     IsClose(Vector3d(-held, 1, 0), Rounding(64)));
    }
}

TEST_CASE("contact: simultaneously any friction counts", "[A5.5][contact]")
{
    for (const double friction : {0x1p-40, 0x1p-20, 0.5, 1.5, 1.9, 2.5, 1e6}) {
        CAPTURE(friction);
        const ContactCase problem = sliding_ball(friction);
        const double held = std::min(friction, 2.0);
        const Vector3d j = resolve_simultaneously(problem.bodies, problem.contacts, 3).impulses[0];
        REQUIRE_THAT(j.x(), IsClose(-held, Rounding(64)));
        REQUIRE_THAT(j.y(), IsClose(1.0, Rounding(64)));
    }
}

TEST_CASE("contact: one at a time a turntable takes a ball along", "[A5.2][contact]")
{
    check_turntables([](const ContactCase& problem) {
        return resolve_contacts(problem.bodies, problem.contacts, 1);
    });
}

TEST_CASE("contact: on its way up a turntable takes a ball along", "[A5.4][contact]")
{
    check_turntables([](const ContactCase& problem) {
        return shock_propagation(problem.bodies, problem.contacts, {0, 1}, 1);
    });
}

TEST_CASE("contact: simultaneously a turntable takes a ball along", "[A5.5][contact]")
{
    check_turntables([](const ContactCase& problem) {
        return resolve_simultaneously(problem.bodies, problem.contacts, 1);
    });
}

TEST_CASE("contact: levels may be far apart", "[A5.4][contact]")
{
    // the upper block is stopped by the lower one, which is held
    const ContactCase problem = stack({1, 1});
    for (const int level : {2, 50, 5000}) {
        CAPTURE(level);
        const ContactResult result =
            shock_propagation(problem.bodies, problem.contacts, {0, level - 1, level}, 1);
        for (int i = 1; i <= 2; ++i)
            REQUIRE_THAT(result.bodies[i].velocity, IsClose(Vector3d(0, 0, 0), Rounding(64, 1)));
        REQUIRE_THAT(result.impulses[1], IsClose(up, Rounding(64)));
    }
}

TEST_CASE("contact: any levels in a long list of contacts", "[A5.4][contact]")
{
    // A stack of two blocks beside thousands of contacts between grounds. A number that is made of
    // a level and an index needs more than 32 bits here.
    ContactCase problem = stack({1, 1});
    problem.bodies.emplace_back(); // another ground
    const int ground = static_cast<int>(problem.bodies.size()) - 1;
    const BodyContact between = touch(0, ground, 0.02);
    problem.contacts.insert(problem.contacts.begin(), 30'000, between);
    problem.contacts.insert(problem.contacts.end(), 40'000, between);
    Random random(4);
    for (int i = 0; i < 8; ++i) {
        const int low = 1 + random_index(random, 900'000),
                  high = low + 1 + random_index(random, 1'000'000 - static_cast<std::size_t>(low));
        CAPTURE(low, high);
        const ContactResult result =
            shock_propagation(problem.bodies, problem.contacts, {0, low, high, 0}, 1);
        for (int body = 1; body <= 2; ++body)
            REQUIRE_THAT(result.bodies[body].velocity, IsClose(Vector3d(0, 0, 0), Rounding(64, 1)));
        REQUIRE_THAT(result.impulses[30'001], IsClose(up, Rounding(64)));
    }
}

} // namespace contact_strata_test
