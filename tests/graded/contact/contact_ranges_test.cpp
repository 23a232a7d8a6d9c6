// SPDX-License-Identifier: MIT
// A5: long lists with equal depths, many iterations, many sweeps, high towers, contacts between
// levels that are not neighbors.
#include "contact_cases.hpp"
#include "formulas/contact.hpp"
#include "support/close.hpp"
#include "support/seeds.hpp"

namespace rigor::testing {

namespace {

// The stack of n blocks of 1 kg. With `is_reversed` the bodies are numbered from above; the
// contacts stay in their order, from below.
ContactCase numbered_stack(int n, bool is_reversed)
{
    ContactCase problem = stack(std::vector<double>(static_cast<std::size_t>(n), 1.0));
    if (!is_reversed) return problem;
    std::reverse(problem.bodies.begin(), problem.bodies.end());
    for (BodyContact& contact : problem.contacts) {
        contact.body1 = n - contact.body1;
        contact.body2 = n - contact.body2;
    }
    return problem;
}

} // namespace

TEST_CASE("contact: equal depths keep the order of a long list", "[A5.2][contact]")
{
    // The lowest block stops. Each further contact makes the speeds of its two blocks equal, so its
    // impulse is half of the impulse before it.
    for (const bool is_reversed : {false, true}) {
        CAPTURE(is_reversed);
        const ContactCase problem = numbered_stack(50, is_reversed);
        const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, 1);
        for (int k = 0; k < 50; ++k) {
            CAPTURE(k);
            REQUIRE_THAT(result.impulses[k],
                         IsClose(Vector3d(std::exp2(-k) * up), Rounding(64, 1)));
        }
    }
}

TEST_CASE("contact: the last of many iterations stops the approach", "[A5.2][contact]")
{
    for (const int n : {1, 10, 100, 160, 500}) {
        CAPTURE(n);
        const ContactCase problem = stack({1});
        const ContactResult result = resolve_contacts(problem.bodies, problem.contacts, n);
        REQUIRE_THAT(result.impulses[0], IsClose(up, Rounding(16.0 * n + 64, 1)));
        REQUIRE_THAT(result.bodies[1].velocity, IsClose(Vector3d(0, 0, 0), Rounding(64, 1)));
    }
}

namespace {

// Checks a tower of a thousand blocks. The lowest ones are at rest, and the others fall at 1 m/s.
// @param largest_gap  the largest difference of the levels of a block and of the one below it
void check_tower(int at_rest, int largest_gap, Random& random)
{
    CAPTURE(at_rest, largest_gap);
    const int n = 1000;
    ContactCase problem = stack(std::vector<double>(n, 1.0));
    ContactResult expected{problem.bodies, {}};
    std::vector<int> levels = {0};
    for (int i = 1; i <= n; ++i) {
        levels.push_back(levels.back() + 1 +
                         random_index(random, static_cast<std::size_t>(largest_gap)));
        if (i <= at_rest) problem.bodies[i].velocity.setZero();
        expected.bodies[i].velocity.setZero();
        expected.impulses.push_back((i > at_rest ? 1 : 0) * up);
    }
    REQUIRE_THAT(shock_propagation(problem.bodies, problem.contacts, levels, 1),
                 IsClose(expected, Rounding(64, 1)));
}

} // namespace

TEST_CASE("contact: a high tower is stopped in one pass", "[A5.4][contact]")
{
    for (Random random : seeds(1)) {
        for (const int at_rest : {0, 1, 2, 3, 4, 5, 10, 20, 50, 300})
            check_tower(at_rest, 1, random);
        check_tower(0, 400, random);
    }
}

TEST_CASE("contact: all bodies of lower levels are held", "[A5.4][contact]")
{
    // body 3, which has level 3, falls on a body of level 0, 1 or 2
    for (int lower = 0; lower < 3; ++lower) {
        CAPTURE(lower);
        ContactCase problem = {{Body(), block(1), block(2), block(3, -up)},
                               {touch(3, lower, 0.01)}};
        const ContactResult result =
            shock_propagation(problem.bodies, problem.contacts, {0, 1, 2, 3}, 1);
        REQUIRE_THAT(result.bodies[lower], IsExactly(problem.bodies[lower]));
        REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(3 * up), Rounding(64, 3)));
    }
}

TEST_CASE("contact: within a level the deepest contact comes first", "[A5.4][contact]")
{
    // Two blocks of one level fall together, and the lower one is to stop on the ground. If their
    // own contact comes first, it sees no approach yet, and the upper block falls on. Of equal
    // depths the first one in the list comes first.
    for (const double depth : {0.005, 0.01, 0.02}) // the contact on the ground has 0.01
        for (const bool is_pair_first : {true, false}) {
            CAPTURE(depth, is_pair_first);
            ContactCase problem = stack({1, 1});
            problem.contacts[1].depth = depth;
            if (is_pair_first) std::swap(problem.contacts[0], problem.contacts[1]);
            const ContactResult result =
                shock_propagation(problem.bodies, problem.contacts, {0, 1, 1}, 1);
            const double left = depth > 0.01 || (depth == 0.01 && is_pair_first) ? 1 : 0.5;
            REQUIRE_THAT(result.bodies[2].velocity, IsClose(Vector3d(-left * up), Rounding(64, 1)));
        }
}

TEST_CASE("contact: each of many sweeps visits the contacts in the order given", "[A5.5][contact]")
{
    const ContactCase problem = {{Body(), rod(-up)},
                                 {touch(1, 0, 0.01, {-1, 0, 0}), touch(1, 0, 0.01, {1, 0, 0})}};
    double left = 0, right = 0;
    for (int sweeps = 1; sweeps <= 25; ++sweeps) {
        CAPTURE(sweeps);
        left = std::max(0.0, left - (-1 + 4 * left - 2 * right) / 4);
        right = std::max(0.0, right - (-1 + 4 * right - 2 * left) / 4);
        const ContactResult result =
            resolve_simultaneously(problem.bodies, problem.contacts, sweeps);
        REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(left * up), Rounding(64, 4)));
        REQUIRE_THAT(result.impulses[1], IsClose(Vector3d(right * up), Rounding(64, 4)));
    }
}

} // namespace rigor::testing
