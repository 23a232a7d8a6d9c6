// SPDX-License-Identifier: MIT
// A5.2 to A5.5: lists of every length, and bodies whose indices need more than 8 or 16 bits.
#include "contact_cases.hpp"
#include "graded/laws/lengths.hpp"
#include "support/close.hpp"

namespace contact_lengths_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr int most = 4096; // bodies in one call, each with a contact

// Numbers of contacts: all short lists, and one whose indices need more than 16 bits.
std::vector<int> contact_counts()
{
    std::vector<int> counts = lengths(0, most);
    counts.push_back(wide + 100);
    return counts;
}

// Blocks that fall on the ground at different speeds.
ContactCase falling_blocks(int n)
{
    ContactCase problem{{Body()}, {}};
    for (int i = 1; i <= n; ++i) {
        problem.bodies.push_back(block(1, -(1 + i % 7) * up));
        problem.contacts.push_back(touch(i, 0, 0.01 * (i % 5)));
    }
    return problem;
}

// @param resolve  computes the ContactResult from a ContactCase and the levels of its bodies
template <class Resolve> void check_lengths(const Resolve& resolve)
{
    for (const int n : contact_counts()) {
        CAPTURE(n);
        const ContactCase problem = falling_blocks(n);
        std::vector<int> levels(problem.bodies.size(), 1);
        levels[0] = 0;
        const ContactResult result = resolve(problem, levels);
        std::vector<Vector3d> expected, velocities;
        for (int i = 1; i <= n; ++i) {
            expected.push_back((1 + i % 7) * up);
            velocities.push_back(result.bodies[i].velocity);
        }
        REQUIRE_THAT(result.impulses, IsClose(expected, Rounding(64, 8)));
        const std::vector<Vector3d> at_rest(velocities.size(), Vector3d::Zero());
        REQUIRE_THAT(velocities, IsClose(at_rest, Rounding(64, 8)));
    }
}

// Pairs of blocks whose indices have the same last 8 or 16 bits. The first block of each pair runs
// into the second one, and both move on at half the speed of the first.
template <class Resolve> void check_indices(const Resolve& resolve)
{
    constexpr int count = wide + 2 * narrow;
    ContactCase problem{Bodies(count, block(1)), {}};
    std::vector<double> speeds(count, 0.0);
    for (const auto& [least, step] :
         {std::pair(1, narrow), std::pair(11, wide), std::pair(21, wide + narrow)})
        for (int i = 0; i < 3; ++i) {
            const int first = least + i, second = first + step;
            const double speed = static_cast<double>(problem.contacts.size()) + 1;
            problem.bodies[first].velocity = -speed * up;
            problem.contacts.push_back(touch(first, second, 0.01));
            if (i == 1) std::swap(problem.contacts.back().body1, problem.contacts.back().body2);
            if (i == 1) problem.contacts.back().normal = -up;
            speeds[first] = speeds[second] = speed / 2;
        }
    const ContactResult result = resolve(problem, std::vector<int>(count, 1));
    for (std::size_t i = 0; i < problem.contacts.size(); ++i)
        REQUIRE_THAT(result.impulses[i].norm(),
                     IsClose((1 + static_cast<double>(i)) / 2, Rounding(64)));
    for (int i = 0; i < count; ++i)
        if (result.bodies[i].velocity != -speeds[i] * up) {
            CAPTURE(i);
            REQUIRE_THAT(result.bodies[i].velocity,
                         IsClose(Vector3d(-speeds[i] * up), Rounding(64, 8)));
        }
}

ContactResult one_at_a_time(const ContactCase& problem, const std::vector<int>&)
{
    return resolve_contacts(problem.bodies, problem.contacts, 1);
}

ContactResult level_by_level(const ContactCase& problem, const std::vector<int>& levels)
{
    return shock_propagation(problem.bodies, problem.contacts, levels, 1);
}

ContactResult at_once(const ContactCase& problem, const std::vector<int>&)
{
    return resolve_simultaneously(problem.bodies, problem.contacts, 1);
}

} // namespace

TEST_CASE("contact: one at a time any number of contacts", "[A5.2][contact]")
{
    check_lengths(one_at_a_time);
}

TEST_CASE("contact: on one level any number of contacts", "[A5.4][contact]")
{
    check_lengths(level_by_level);
}

TEST_CASE("contact: simultaneously any number of contacts", "[A5.5][contact]")
{
    check_lengths(at_once);
}

TEST_CASE("contact: one at a time indices of many bits", "[A5.2][contact]")
{
    check_indices(one_at_a_time);
}

TEST_CASE("contact: level by level indices of many bits", "[A5.4][contact]")
{
    check_indices(level_by_level);
}

TEST_CASE("contact: simultaneously indices of many bits", "[A5.5][contact]")
{
    check_indices(at_once);
}

TEST_CASE("contact: the levels of any number of cycles", "[A5.3][contact]")
{
    for (const int n :
         {1, 2, 3, 15, 16, 17, 64, 127, 128, 255, 256, 257, 300, 1000, 32768, 65537}) {
        CAPTURE(n);
        // pairs that lean on each other, each pair on the one below
        std::vector<std::vector<int>> rests_on;
        std::vector<int> expected;
        for (int i = 0; i < n; ++i) {
            rests_on.push_back({2 * i + 1});
            rests_on.push_back({2 * i});
            if (i > 0) rests_on[2 * i].push_back(2 * i - 2);
            expected.insert(expected.end(), 2, i + 1);
        }
        REQUIRE_THAT(contact_levels(rests_on, std::vector<bool>(rests_on.size())),
                     IsExactly(expected));
    }
}

TEST_CASE("contact: the levels of any number of bodies", "[A5.3][contact]")
{
    for (const int n : lengths(0, most)) {
        CAPTURE(n);
        // columns of four bodies on static ones, a body that rests on all others, and three on it
        std::vector<std::vector<int>> rests_on(static_cast<std::size_t>(n));
        std::vector<bool> is_static(static_cast<std::size_t>(n));
        std::vector<int> expected;
        for (int i = 0; i < n; ++i) {
            is_static[i] = i % 5 == 0;
            if (i % 5 != 0) rests_on[i] = {i - 1};
            expected.push_back(i % 5);
        }
        rests_on.emplace_back();
        for (int i = 0; i < n; ++i)
            rests_on.back().push_back(i);
        is_static.push_back(false);
        expected.push_back(1 + std::min(std::max(n - 1, 0), 4));
        for (int i = n; i < n + 3; ++i) {
            rests_on.push_back({i});
            is_static.push_back(false);
            expected.push_back(expected.back() + 1);
        }
        REQUIRE_THAT(contact_levels(rests_on, is_static), IsExactly(expected));
    }
}

TEST_CASE("contact: the levels of bodies with indices of many bits", "[A5.3][contact]")
{
    constexpr int count = wide + 2 * narrow, first = 7;
    std::vector<std::vector<int>> rests_on(count);
    std::vector<int> expected(count, 1);
    // a column of bodies; their indices have the same last 8 bits, some the same last 16
    const int column[] = {first, first + narrow, first + wide, first + wide + narrow};
    for (int i = 1; i < 4; ++i) {
        rests_on[column[i]] = {column[i - 1]};
        expected[column[i]] = 1 + i;
    }
    REQUIRE_THAT(contact_levels(rests_on, std::vector<bool>(count)), IsExactly(expected));
}

} // namespace contact_lengths_test
