// SPDX-License-Identifier: MIT
// A5.3: the levels of bodies, which say how high a body stands.
#include "formulas/contact.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <numeric>

namespace rigor::testing {

namespace {

using Edges = std::vector<std::vector<int>>;
using Levels = std::vector<int>;

// The first body is static, the others are not.
std::vector<bool> on_the_ground(std::size_t count)
{
    std::vector<bool> is_static(count, false);
    if (count > 0) is_static[0] = true;
    return is_static;
}

void check_levels(const Edges& rests_on, const Levels& expected)
{
    REQUIRE_THAT(contact_levels(rests_on, on_the_ground(rests_on.size())), IsExactly(expected));
}

// reaches[i][j] tells whether i rests on j, directly or through others that are not static.
std::vector<std::vector<bool>> reachable(const Edges& rests_on, const std::vector<bool>& is_static)
{
    const std::size_t n = rests_on.size();
    std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n, false));
    for (std::size_t i = 0; i < n; ++i)
        if (!is_static[i])
            for (int j : rests_on[i])
                reaches[i][j] = true;
    for (std::size_t via = 0; via < n; ++via)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                if (reaches[i][via] && reaches[via][j]) reaches[i][j] = true;
    return reaches;
}

// Checks levels against each sentence of their definition in the header.
void check_definition(const Edges& rests_on, const std::vector<bool>& is_static,
                      const Levels& levels)
{
    REQUIRE(levels.size() == rests_on.size());
    const auto reaches = reachable(rests_on, is_static);
    const auto in_cycle = [&](std::size_t i, std::size_t j) {
        return i == j || (reaches[i][j] && reaches[j][i]);
    };
    for (std::size_t i = 0; i < levels.size(); ++i) {
        int expected = is_static[i] ? 0 : 1;
        for (std::size_t member = 0; member < levels.size() && !is_static[i]; ++member)
            if (in_cycle(i, member))
                for (int below : rests_on[member])
                    if (!in_cycle(i, static_cast<std::size_t>(below)))
                        expected = std::max(expected, levels[below] + 1);
        CAPTURE(i);
        REQUIRE_THAT(levels[i], IsExactly(expected));
    }
}

} // namespace

TEST_CASE("contact: the level of a body is the longest way down", "[A5.3][contact]")
{
    check_levels({{}, {0}, {1}, {2}}, {0, 1, 2, 3});               // a stack
    check_levels({{}, {2}, {3}, {0}}, {0, 3, 2, 1});               // numbered from the top
    check_levels({{}, {0}, {0}, {1, 2}, {3, 0}}, {0, 1, 1, 2, 3}); // a table and a leaning board
    check_levels({{}, {0}, {1}, {2, 0}, {0, 3}},
                 {0, 1, 2, 3, 4});                    // the ground is never the highest
    check_levels({{}, {0}, {1, 1, 0, 1}}, {0, 1, 2}); // several points of one contact
}

TEST_CASE("contact: what rests on nothing has level 1", "[A5.3][contact]")
{
    check_levels({{}, {}, {1}}, {0, 1, 2});
    REQUIRE_THAT(contact_levels({{}, {0}}, {false, false}), IsExactly(Levels{1, 2}));
    REQUIRE(contact_levels({}, {}).empty());
}

TEST_CASE("contact: static bodies have level 0 whatever they rest on", "[A5.3][contact]")
{
    // a shelf on brackets, and a box on it
    REQUIRE_THAT(contact_levels({{}, {0}, {1}}, {true, true, false}), IsExactly(Levels{0, 0, 1}));
    // a box on the floor below the shelf, which touches it from above
    REQUIRE_THAT(contact_levels({{}, {0}, {1}, {2}}, {true, false, true, false}),
                 IsExactly(Levels{0, 1, 0, 1}));
}

TEST_CASE("contact: a cycle shares one level", "[A5.3][contact]")
{
    check_levels({{}, {0, 2}, {1}}, {0, 1, 1});                 // two cards lean on each other
    check_levels({{}, {0, 3}, {1}, {2}, {2}}, {0, 1, 1, 1, 2}); // three cards, and a body on them
    check_levels({{}, {0}, {1, 3}, {2}, {3}}, {0, 1, 2, 2, 3}); // a pair of cards on a block
    check_levels({{}, {2}, {1}}, {0, 1, 1});                    // a pair rests on nothing else
    check_levels({{}, {1, 0}, {1, 2}}, {0, 1, 2});              // a body rests on itself
}

TEST_CASE("contact: the level of a cycle is above all that any of it rests on", "[A5.3][contact]")
{
    // 4 and 5 lean on each other; 4 rests on the ground, 5 on a stack of three
    check_levels({{}, {0}, {1}, {2}, {0, 5}, {3, 4}, {4}}, {0, 1, 2, 3, 4, 4, 5});
    // a figure of eight: two cycles that share body 1 count as one
    check_levels({{}, {2, 3, 0}, {1}, {1}, {3}}, {0, 1, 1, 1, 2});
    // one cycle on top of another
    check_levels({{}, {0, 2}, {1}, {2, 4}, {3}, {4}}, {0, 1, 1, 2, 2, 3});
    // a long cycle 1 → 2 → 3 → 4 → 1 with a shortcut 3 → 1
    check_levels({{}, {2}, {3}, {4, 1}, {1, 0}}, {0, 1, 1, 1, 1});
}

TEST_CASE("contact: no cycle leads through a static body", "[A5.3][contact]")
{
    // 1 rests on 2, which is static and touches 3, which rests on 1
    REQUIRE_THAT(contact_levels({{}, {2}, {3}, {1}}, {true, false, true, false}),
                 IsExactly(Levels{0, 1, 0, 2}));
}

TEST_CASE("contact: levels of random bodies are those of the definition", "[A5.3][contact]")
{
    for (unsigned seed : seeds(200)) {
        Random random(seed);
        const int n = 2 + static_cast<int>(seed % 12);
        Edges rests_on(n);
        std::vector<bool> is_static;
        for (int i = 0; i < n; ++i)
            is_static.push_back(random.uniform(0, 1) < 0.2);
        const double edges = random.uniform(0, 2) * n;
        for (int edge = 0; edge < edges; ++edge) {
            const int from = static_cast<int>(random.uniform(0, n));
            rests_on[from].push_back(static_cast<int>(random.uniform(0, n)));
        }
        check_definition(rests_on, is_static, contact_levels(rests_on, is_static));
    }
}

TEST_CASE("contact: levels do not depend on how bodies are numbered", "[A5.3][contact]")
{
    const Edges rests_on = {{}, {0}, {1}, {2}, {0, 5}, {3, 4}, {4}, {6, 1}};
    const Levels expected = {0, 1, 2, 3, 4, 4, 5, 6};
    const int n = static_cast<int>(rests_on.size());
    for (Random random : seeds(50)) {
        std::vector<int> number(n); // new number of each body
        std::iota(number.begin(), number.end(), 0);
        for (int i = n - 1; i > 0; --i)
            std::swap(number[i], number[static_cast<int>(random.uniform(0, i + 1))]);
        Edges numbered(n);
        std::vector<bool> is_static(n, false);
        Levels wanted(n);
        is_static[number[0]] = true;
        for (int i = 0; i < n; ++i) {
            wanted[number[i]] = expected[i];
            for (int below : rests_on[i])
                numbered[number[i]].push_back(number[below]);
        }
        REQUIRE_THAT(contact_levels(numbered, is_static), IsExactly(wanted));
    }
}

TEST_CASE("contact: a stack of a hundred thousand bodies", "[A5.3][contact]")
{
    constexpr int n = 100000;
    Edges upwards(n + 1), downwards(n + 1);
    Levels levels(n + 1), from_the_top(n + 1, 0);
    for (int i = 1; i <= n; ++i) {
        upwards[i] = {i - 1};
        levels[i] = i;
        downwards[i] = {i == n ? 0 : i + 1};
        from_the_top[i] = n + 1 - i;
    }
    check_levels(upwards, levels);
    check_levels(downwards, from_the_top);
}

TEST_CASE("contact: a ring of a hundred thousand bodies is one cycle", "[A5.3][contact]")
{
    constexpr int n = 100000;
    Edges ring(n + 2);
    Levels levels(n + 2, 1);
    for (int i = 1; i <= n; ++i)
        ring[i] = {i == n ? 1 : i + 1};
    ring[n / 2].push_back(0);
    ring[n + 1] = {n / 3};
    levels[0] = 0;
    levels[n + 1] = 2;
    check_levels(ring, levels);
}

} // namespace rigor::testing
