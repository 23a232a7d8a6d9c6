// SPDX-License-Identifier: MIT
// A5: contacts that hardly approach, and static bodies that move.
#include "contact_laws.hpp"
#include "formulas/contact.hpp"
#include "support/seeds.hpp"

namespace rigor::testing {

namespace {

// A static belt that runs along x, and a ball on it that falls at `speed`.
ContactCase ball_on_belt(double speed, double friction)
{
    Body belt;
    belt.velocity = Vector3d(2, 0, 0);
    return {{belt, ball(1, {0, -speed, 0})}, {touch(1, 0, 0.01, {0, 0, 0}, friction)}};
}

} // namespace

TEST_CASE("contact: one at a time a moving belt takes a ball along", "[A5.2][contact]")
{
    // one plastic iteration: the ball slides on the belt, so friction is μ jₙ
    const ContactCase problem = ball_on_belt(1, 0.1);
    const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, 1);
    REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(0.1, 1, 0), Rounding(32)));
    REQUIRE_THAT(result.bodies[0], IsExactly(problem.bodies[0]));
    REQUIRE_THAT(result.bodies[1].velocity, IsClose(Vector3d(0.1, 0, 0), Rounding(32, 2)));
}

TEST_CASE("contact: simultaneously a moving belt takes a ball along", "[A5.5][contact]")
{
    const ContactCase problem = ball_on_belt(1, 0.1);
    const ContactResult result = resolve_simultaneously(problem.bodies, problem.contacts, 1);
    REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(0.1, 1, 0), Rounding(32)));
    REQUIRE_THAT(result.bodies[0], IsExactly(problem.bodies[0]));
}

TEST_CASE("contact: on its way up a moving belt takes a ball along", "[A5.4][contact]")
{
    const ContactCase problem = ball_on_belt(1, 0.1);
    const ContactResult result = shock_propagation(problem.bodies, problem.contacts, {0, 1}, 1);
    REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(0.1, 1, 0), Rounding(32)));
    REQUIRE_THAT(result.bodies[0], IsExactly(problem.bodies[0]));
}

TEST_CASE("contact: bodies that hardly approach are stopped", "[A5.2][contact]")
{
    for (const double speed : {1e-3, 1e-6, 1e-9, 1e-12}) {
        CAPTURE(speed);
        const ContactCase problem = ball_on_belt(speed, 0);
        const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, 4);
        REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(0, speed, 0), Rounding(64)));
    }
}

TEST_CASE("contact: one at a time a body that is far heavier is pushed too", "[A5.2][contact]")
{
    for (const double mass : {1e3, 1e6, 1e9, 1e12, 1e15}) {
        CAPTURE(mass);
        const Bodies bodies = {block(mass), block(1, {0, -1, 0}, {0, 0.1, 0})};
        const ContactResult result = resolve_contacts(bodies, {touch(1, 0, 0.01)}, 1);
        const double j = mass / (1 + mass);
        REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(0, j, 0), Rounding(32)));
        REQUIRE_THAT(result.bodies[0].velocity, IsClose(Vector3d(0, -j / mass, 0), Rounding(32)));
    }
}

TEST_CASE("contact: one at a time the separation speed is reached to the last digits",
          "[A5.2][contact]")
{
    for (const double s : {-10., -1e-3})
        for (int power = 4; power <= 40; power += 4) {
            CAPTURE(s, power);
            const double missing = std::ldexp(-s, -power);
            ContactCase problem = ball_on_belt(-s + missing, 0);
            problem.contacts[0].separation_speed = s;
            const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, 1);
            REQUIRE_THAT(result.impulses[0],
                         IsClose(Vector3d(0, missing, 0), Rounding(32, std::abs(s))));
        }
}

TEST_CASE("contact: simultaneously bodies that hardly approach are stopped", "[A5.5][contact]")
{
    for (const double speed : {1e-3, 1e-6, 1e-9, 1e-12}) {
        CAPTURE(speed);
        const ContactCase problem = ball_on_belt(speed, 0);
        const ContactResult result = resolve_simultaneously(problem.bodies, problem.contacts, 4);
        REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(0, speed, 0), Rounding(64)));
    }
}

} // namespace rigor::testing
