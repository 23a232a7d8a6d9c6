// SPDX-License-Identifier: MIT
// A5: many iterations, each of which has its own restitution; bodies that are numbered otherwise,
// which changes no result; and a world of static bodies at the origin, which stays as it is.
#include "contact_cases.hpp"
#include "formulas/contact.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <limits>

namespace contact_order_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

const Vector3d zero = Vector3d::Zero();

// A world of static bodies at the origin: all their positions and velocities are zero.
const ContactCase nothing_moves = {{Body(), Body()}, {touch(1, 0, 0.01)}};

void check_unchanged(const ContactResult& result)
{
    check_count(result.bodies.size(), 2, "bodies");
    check_count(result.impulses.size(), 1, "impulses, one for each contact");
    REQUIRE_THAT(result.impulses[0], IsExactly(zero));
    for (const Body& body : result.bodies)
        REQUIRE_THAT(body, IsExactly(Body()));
}

// The same case with its bodies in opposite order.
ContactCase renumbered(ContactCase problem)
{
    const int last = static_cast<int>(problem.bodies.size()) - 1;
    std::reverse(problem.bodies.begin(), problem.bodies.end());
    for (BodyContact& c : problem.contacts) {
        c.body1 = last - c.body1;
        c.body2 = last - c.body2;
    }
    return problem;
}

// Compares two results, one of which has its bodies in opposite order. The sums of a contact may be
// formed in another order; a pile of balls magnifies their rounding errors by much less than 2^20.
void check_same(ContactResult result, const ContactResult& expected)
{
    std::reverse(result.bodies.begin(), result.bodies.end());
    REQUIRE_THAT(result, IsClose(expected, Rounding(1 << 20, 16)));
}

std::vector<int> levels_of(const Bodies& bodies, Random& random)
{
    std::vector<int> levels;
    for (const Body& body : bodies)
        levels.push_back(body.is_static() ? 0 : 1 + static_cast<int>(random.bits() % 3));
    return levels;
}

} // namespace

TEST_CASE("contact: restitution rises evenly in a billion iterations", "[A5.1][contact]")
{
    std::vector<int> counts = {std::numeric_limits<int>::max()};
    for (int power = 1; power <= 30; ++power)
        for (const int beside : {-1, 0, 1})
            counts.push_back((1 << power) + beside);
    for (const int n : counts) {
        CAPTURE(n);
        for (const int k : {0, 1, n / 3, n / 2, n - 3, n - 2, n - 1})
            if (k >= 0 && k < n) {
                CAPTURE(k);
                // ε = (k + 1)/n - 1 = -(n - 1 - k)/n
                const double epsilon = -static_cast<double>(n - 1 - k) / n;
                REQUIRE_THAT(contact_restitution(k, n), IsClose(epsilon, Rounding(2, 1)));
            }
    }
}

TEST_CASE("contact: a world without motion at the origin stays", "[A5.2][contact]")
{
    check_unchanged(resolve_contacts(nothing_moves.bodies, nothing_moves.contacts, 2));
}

TEST_CASE("contact: level by level a world without motion at the origin stays", "[A5.4][contact]")
{
    check_unchanged(shock_propagation(nothing_moves.bodies, nothing_moves.contacts, {0, 0}, 2));
}

TEST_CASE("contact: simultaneously a world without motion at the origin stays", "[A5.5][contact]")
{
    check_unchanged(resolve_simultaneously(nothing_moves.bodies, nothing_moves.contacts, 2));
}

TEST_CASE("contact: one at a time the numbers of bodies do not matter", "[A5.2][contact]")
{
    for (unsigned seed : seeds(20)) {
        const ContactCase one = pile_of_balls(seed), other = renumbered(one);
        check_same(resolve_contacts(other.bodies, other.contacts, 3),
                   resolve_contacts(one.bodies, one.contacts, 3));
    }
}

TEST_CASE("contact: level by level the numbers of bodies do not matter", "[A5.4][contact]")
{
    for (unsigned seed : seeds(20)) {
        Random random(seed);
        const ContactCase one = pile_of_balls(seed), other = renumbered(one);
        std::vector<int> levels = levels_of(one.bodies, random);
        const ContactResult expected = shock_propagation(one.bodies, one.contacts, levels, 3);
        std::reverse(levels.begin(), levels.end());
        check_same(shock_propagation(other.bodies, other.contacts, levels, 3), expected);
    }
}

TEST_CASE("contact: simultaneously the numbers of bodies do not matter", "[A5.5][contact]")
{
    for (unsigned seed : seeds(20)) {
        const ContactCase one = pile_of_balls(seed), other = renumbered(one);
        check_same(resolve_simultaneously(other.bodies, other.contacts, 3),
                   resolve_simultaneously(one.bodies, one.contacts, 3));
    }
}

TEST_CASE("contact: each of many iterations of a level has its own restitution", "[A5.4][contact]")
{
    const ContactCase problem = rod_on_both_ends();
    for (const int n : {1, 2, 3, 10, 25, 60, 200}) {
        CAPTURE(n);
        const std::array<double, 2> sums = impulses_on_both_ends(n);
        const ContactResult result = shock_propagation(problem.bodies, problem.contacts, {0, 1}, n);
        for (int i = 0; i < 2; ++i)
            REQUIRE_THAT(result.impulses[i],
                         IsClose(Vector3d(sums[i] * up), Rounding(32.0 * n + 64, 1)));
    }
}

} // namespace contact_order_test
