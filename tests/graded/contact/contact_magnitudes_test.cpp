// SPDX-License-Identifier: MIT
// A5.2, A5.4, A5.5: coefficients of friction of every size, and A5.4: numbers of levels of every
// size.
#include "contact_cases.hpp"
#include "formulas/contact.hpp"
#include "support/close.hpp"

#include <cmath>

namespace rigor::testing {

namespace {

// A block falls on the ground while it slides along x. It sticks if the friction is at least its
// sliding speed over its speed of fall, and otherwise the impulse is on the border of the cone.
// `more` contacts of the same two bodies have nothing left to do, whatever their friction is.
// @param resolve  computes the ContactResult from a ContactCase
template <class Resolve>
void check_frictions(const Resolve& resolve, const std::vector<BodyContact>& more = {})
{
    for (int power = -30; power <= 30; ++power)
        for (const double share : {0.25, 0.75, 1.5, 1e3}) {
            const double slide = std::ldexp(1, power), friction = share * slide;
            CAPTURE(slide, friction);
            ContactCase problem{{Body(), block(1, {slide, -1, 0})}, {touch(1, 0, 0.01)}};
            problem.contacts[0].friction = friction;
            problem.contacts.insert(problem.contacts.end(), more.begin(), more.end());
            const ContactResult result = resolve(problem);
            const Vector3d j(-std::min(friction, slide), 1, 0);
            REQUIRE_THAT(result.impulses[0], IsClose(j, Rounding(64, 1 + slide)));
            for (std::size_t i = 1; i < problem.contacts.size(); ++i)
                REQUIRE_THAT(result.impulses[i],
                             IsClose(Vector3d(0, 0, 0), Rounding(64, 1 + slide)));
            REQUIRE_THAT(result.bodies[1].velocity,
                         IsClose(Vector3d(slide + j.x(), 0, 0), Rounding(64, 1 + slide)));
        }
}

// A smooth and a rough contact of the same two bodies, less deep than that of `check_frictions`.
std::vector<BodyContact> other_frictions()
{
    return {touch(1, 0, 0.005), touch(1, 0, 0.002, {0, 0, 0}, 1e12)};
}

} // namespace

TEST_CASE("contact: one at a time friction of any size", "[A5.2][contact]")
{
    check_frictions([](const ContactCase& c) { return resolve_contacts(c.bodies, c.contacts, 1); });
}

TEST_CASE("contact: on one level friction of any size", "[A5.4][contact]")
{
    check_frictions([](const ContactCase& c) {
        return shock_propagation(c.bodies, c.contacts, {0, 1}, 1);
    });
}

TEST_CASE("contact: simultaneously friction of any size", "[A5.5][contact]")
{
    check_frictions(
        [](const ContactCase& c) { return resolve_simultaneously(c.bodies, c.contacts, 1); });
}

TEST_CASE("contact: one at a time each contact has its own friction", "[A5.2][contact]")
{
    check_frictions([](const ContactCase& c) { return resolve_contacts(c.bodies, c.contacts, 1); },
                    other_frictions());
}

TEST_CASE("contact: on one level each contact has its own friction", "[A5.4][contact]")
{
    check_frictions(
        [](const ContactCase& c) {
            return shock_propagation(c.bodies, c.contacts, {0, 1}, 1);
        },
        other_frictions());
}

TEST_CASE("contact: simultaneously each contact has its own friction", "[A5.5][contact]")
{
    check_frictions(
        [](const ContactCase& c) { return resolve_simultaneously(c.bodies, c.contacts, 1); },
        other_frictions());
}

TEST_CASE("contact: only the order of the levels counts", "[A5.4][contact]")
{
    // two blocks on each other, each with the number of its level
    const ContactCase problem = stack({1, 3});
    const ContactResult expected =
        shock_propagation(problem.bodies, problem.contacts, {0, 1, 2}, 3);
    const auto check = [&](int lower, int upper) {
        CAPTURE(lower, upper);
        const ContactResult result =
            shock_propagation(problem.bodies, problem.contacts, {0, lower, upper}, 3);
        REQUIRE_THAT(result, IsExactly(expected));
    };
    const int numbers[] = {1,   2,   127,   128,   255,   256,   257,
                           511, 512, 32768, 65535, 65536, 65537, 70000};
    for (const int lower : numbers)
        for (const int upper : numbers)
            if (lower < upper) check(lower, upper);
    check(999'999, 1'000'000); // the contract allows no higher levels
}

} // namespace rigor::testing
