// SPDX-License-Identifier: MIT
// A5.3: the levels of bodies, which say how high a body stands.
#include "formulas/contact.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
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

struct Pile {
    Edges rests_on;
    std::vector<bool> is_static;
    Levels levels;
};

// A new number for each of n bodies.
std::vector<int> shuffled(int n, Random& random)
{
    std::vector<int> number(n);
    std::iota(number.begin(), number.end(), 0);
    for (int i = n - 1; i > 0; --i)
        std::swap(number[i], number[random_index(random, i + 1)]);
    return number;
}

// The bodies in another order, and the list of what each rests on in another order too. So
// self-references and repeated entries may come at any place in a list.
Pile renumbered(const Pile& pile, Random& random)
{
    const std::size_t n = pile.levels.size();
    const std::vector<int> number = shuffled(static_cast<int>(n), random);
    Pile result{Edges(n), std::vector<bool>(n, false), Levels(n)};
    for (std::size_t i = 0; i < n; ++i) {
        result.levels[number[i]] = pile.levels[i];
        result.is_static[number[i]] = pile.is_static[i];
        const std::vector<int>& below = pile.rests_on[i];
        for (const int place : shuffled(static_cast<int>(below.size()), random))
            result.rests_on[number[i]].push_back(number[below[place]]);
    }
    return result;
}

// The pile with a few more bodies, each of which rests on some of those before it.
Pile with_more_bodies(Pile pile, Random& random)
{
    for (int more = 1 + random_index(random, 4); more > 0; --more) {
        std::vector<int> below(1 + random_index(random, 3));
        int level = 1;
        for (int& body : below) {
            body = random_index(random, pile.levels.size());
            level = std::max(level, pile.levels[body] + 1);
        }
        pile.rests_on.push_back(below);
        pile.is_static.push_back(false);
        pile.levels.push_back(level);
    }
    return pile;
}

// Checks the levels, also with more bodies and after all are renumbered at random, so that a
// solution cannot look the answers up in a table.
void check_levels(const Edges& rests_on, const Levels& expected)
{
    const Pile pile{rests_on, on_the_ground(rests_on.size()), expected};
    REQUIRE_THAT(contact_levels(pile.rests_on, pile.is_static), IsExactly(expected));
    for (Random random : seeds(5)) {
        const Pile other = renumbered(with_more_bodies(pile, random), random);
        REQUIRE_THAT(contact_levels(other.rests_on, other.is_static), IsExactly(other.levels));
    }
}

// Adds `size` bodies at this level of a pile: a single body, or a ring of bodies that lean on each
// other.
void add_group(Pile& pile, int size, int level, Random& random)
{
    const int first = static_cast<int>(pile.levels.size());
    std::vector<int> lower, next_below;
    for (int i = 0; i < first; ++i) {
        if (pile.levels[i] < level) lower.push_back(i);
        if (pile.levels[i] == level - 1) next_below.push_back(i);
    }
    for (int i = 0; i < size; ++i) {
        pile.rests_on.emplace_back();
        pile.levels.push_back(level);
        pile.is_static.push_back(false);
        if (size > 1) pile.rests_on.back().push_back(first + (i + 1) % size);
    }
    const auto member = [&] { return first + random_index(random, size); };
    if (level > 1)
        pile.rests_on[member()].push_back(next_below[random_index(random, next_below.size())]);
    for (int extra = random_index(random, 4); extra > 0; --extra)
        pile.rests_on[member()].push_back(lower[random_index(random, lower.size())]);
    if (random.uniform(0, 1) < 0.3) pile.rests_on[member()].push_back(member());
}

// A pile whose levels are known, because it is built from below: each group rests on something of
// the next lower level and on nothing higher. What rests on static bodies alone, or on nothing, has
// level 1. The static bodies rest on anything.
Pile random_pile(Random& random)
{
    Pile pile;
    const int statics = 1 + random_index(random, 3), group_count = 1 + random_index(random, 7);
    pile.rests_on.resize(statics);
    pile.levels.assign(statics, 0);
    pile.is_static.assign(statics, true);
    int highest = 0;
    for (int group = 0; group < group_count; ++group) {
        const int level = 1 + random_index(random, highest + 1);
        add_group(pile, 1 + random_index(random, 3), level, random);
        highest = std::max(highest, level);
    }
    for (int i = 0; i < statics; ++i)
        pile.rests_on[i].push_back(random_index(random, pile.levels.size()));
    return renumbered(pile, random);
}

} // namespace

TEST_CASE("contact: the level of a body is the longest way down", "[A5.3][contact]")
{
    check_levels({{}, {0}, {1}, {2}}, {0, 1, 2, 3});               // a stack
    check_levels({{}, {2}, {3}, {0}}, {0, 3, 2, 1});               // numbered from the top
    check_levels({{}, {0}, {0}, {1, 2}, {3, 0}}, {0, 1, 1, 2, 3}); // a table and a leaning board
    check_levels({{}, {0}, {1}, {2, 0}, {0, 3}},
                 {0, 1, 2, 3, 4});                    // the ground beside others changes nothing
    check_levels({{}, {0}, {1, 1, 0, 1}}, {0, 1, 2}); // several points of one contact
}

TEST_CASE("contact: what rests on nothing has level 1", "[A5.3][contact]")
{
    check_levels({{}, {}, {1}}, {0, 1, 2});
    REQUIRE_THAT(contact_levels({{}, {0}}, {false, false}), IsExactly(Levels{1, 2}));
    check_count(contact_levels({}, {}).size(), 0, "levels");
}

TEST_CASE("contact: static bodies have level 0 whatever they rest on", "[A5.3][contact]")
{
    // a shelf on brackets, and a box on it
    REQUIRE_THAT(contact_levels({{}, {0}, {1}}, {true, true, false}), IsExactly(Levels{0, 0, 1}));
    // a box on the floor below the shelf; the shelf touches the box from above
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
    check_levels({{}, {0}, {2, 1}}, {0, 1, 2});                 // the same, listed first
    check_levels({{}, {0}, {0, 2, 2, 1, 2, 0}}, {0, 1, 2});     // the same, several times
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

TEST_CASE("contact: a pile that is built level by level has these levels", "[A5.3][contact]")
{
    for (Random random : seeds(300)) {
        const Pile pile = random_pile(random);
        REQUIRE_THAT(contact_levels(pile.rests_on, pile.is_static), IsExactly(pile.levels));
    }
}

TEST_CASE("contact: levels do not depend on how bodies are numbered", "[A5.3][contact]")
{
    Pile pile{
        {{}, {0}, {1}, {2}, {0, 5}, {3, 4}, {4}, {6, 1, 7, 7, 1}}, {}, {0, 1, 2, 3, 4, 4, 5, 6}};
    pile.is_static = on_the_ground(pile.levels.size());
    for (Random random : seeds(50)) {
        const Pile other = renumbered(pile, random);
        REQUIRE_THAT(contact_levels(other.rests_on, other.is_static), IsExactly(other.levels));
    }
}

TEST_CASE("contact: a large pile whose bodies rest on few others", "[A5.3][contact]")
{
    // Each body rests on up to three bodies with lower indices, often on the first four. The
    // first of several is listed again at the end.
    for (const int count : {70, 1000, 70'000})
        for (Random random : seeds(3)) {
            CAPTURE(count);
            Pile pile{Edges(count), on_the_ground(count), Levels(count, 0)};
            for (int i = 1; i < count; ++i) {
                std::vector<int>& below = pile.rests_on[i];
                for (int n = random_index(random, 4); n > 0; --n)
                    below.push_back(
                        random_index(random, random_index(random, 2) ? i : std::min(i, 4)));
                if (below.size() > 1) below.push_back(below.front());
                pile.levels[i] = 1;
                for (const int other : below)
                    pile.levels[i] = std::max(pile.levels[i], pile.levels[other] + 1);
            }
            for (const Pile& one : {pile, renumbered(pile, random)})
                REQUIRE_THAT(contact_levels(one.rests_on, one.is_static), IsExactly(one.levels));
        }
}

TEST_CASE("contact: a tall stack whose bodies are numbered from both ends", "[A5.3][contact]")
{
    // from below 0, n - 1, 1, n - 2, …
    const int n = 6000;
    Pile stack{Edges(n), on_the_ground(n), Levels(n)};
    const auto number = [&](int place) { return place % 2 == 0 ? place / 2 : n - 1 - place / 2; };
    for (int place = 0; place < n; ++place) {
        stack.levels[number(place)] = place;
        if (place > 0) stack.rests_on[number(place)] = {number(place - 1)};
    }
    REQUIRE_THAT(contact_levels(stack.rests_on, stack.is_static), IsExactly(stack.levels));
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
    const std::vector<bool> is_static = on_the_ground(upwards.size());
    REQUIRE_THAT(contact_levels(upwards, is_static), IsExactly(levels));
    REQUIRE_THAT(contact_levels(downwards, is_static), IsExactly(from_the_top));
}

TEST_CASE("contact: any member of a long ring may rest on a stack", "[A5.3][contact]")
{
    constexpr int height = 7; // body 0 is the ground, bodies 1 to 7 are the stack
    for (const int n : {100, 2000, 70000})
        for (const int member : {0, 1, n / 3, n / 2, n - 2, n - 1}) {
            CAPTURE(n, member);
            Edges edges(height + n + 1);
            Levels levels(height + n + 1, height + 1);
            for (int i = 0; i <= height; ++i) {
                if (i > 0) edges[i] = {i - 1};
                levels[i] = i;
            }
            for (int i = 0; i < n; ++i)
                edges[height + 1 + i] = {height + 1 + (i + 1) % n};
            edges[height + 1 + member].push_back(height);
            REQUIRE_THAT(contact_levels(edges, on_the_ground(edges.size())), IsExactly(levels));
        }
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
    REQUIRE_THAT(contact_levels(ring, on_the_ground(ring.size())), IsExactly(levels));
}

namespace {

// The levels by their definition. A body reaches the bodies that it rests on, directly or by
// others. Those that reach it too share its level; it is one level above the highest of the rest.
Levels levels_by_reach(const Edges& rests_on, const std::vector<bool>& is_static)
{
    const std::size_t n = rests_on.size();
    std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n, false));
    std::vector<std::pair<std::size_t, std::size_t>> order; // number of reached, body
    for (std::size_t b = 0; b < n; ++b) {
        std::vector<std::size_t> left = {b};
        std::size_t count = 1;
        reaches[b][b] = true;
        while (!left.empty()) {
            const std::size_t from = left.back();
            left.pop_back();
            if (is_static[from]) continue;
            for (const int to : rests_on[from])
                if (!reaches[b][to]) {
                    reaches[b][to] = true;
                    left.push_back(static_cast<std::size_t>(to));
                    ++count;
                }
        }
        order.emplace_back(count, b);
    }
    std::sort(order.begin(), order.end()); // what is below a body comes before it
    Levels levels(n, 0);
    for (const auto& entry : order) {
        const std::size_t b = entry.second;
        if (is_static[b]) continue;
        levels[b] = 1;
        for (std::size_t other = 0; other < n; ++other)
            if (reaches[b][other] && !reaches[other][b])
                levels[b] = std::max(levels[b], levels[other] + 1);
    }
    return levels;
}

} // namespace

TEST_CASE("contact: bodies that rest on any others have the levels of the definition",
          "[A5.3][contact]")
{
    // few edges make trees and long cycles; more edges make cycles that share bodies
    for (Random random : seeds(200))
        for (const std::size_t most : {std::size_t(10), std::size_t(150)}) {
            const int n = 1 + random_index(random, most), edges = 1 + random_index(random, 3);
            const double share = random.uniform(0, 0.2); // the share of static bodies
            Edges rests_on(static_cast<std::size_t>(n));
            std::vector<bool> is_static;
            for (std::vector<int>& below : rests_on) {
                is_static.push_back(random.uniform(0, 1) < share);
                for (int i = random_index(random, static_cast<std::size_t>(edges) + 1); i > 0; --i)
                    below.push_back(random_index(random, static_cast<std::size_t>(n)));
            }
            REQUIRE_THAT(contact_levels(rests_on, is_static),
                         IsExactly(levels_by_reach(rests_on, is_static)));
        }
}

TEST_CASE("contact: a ring is one cycle in whatever order it is numbered", "[A5.3][contact]")
{
    for (Random random : seeds(100))
        for (int n = 2; n <= 12; ++n) {
            const std::vector<int> ring = shuffled(n, random);
            Edges rests_on(static_cast<std::size_t>(n) + 1);
            for (int i = 0; i < n; ++i)
                rests_on[ring[i]].push_back(ring[(i + 1) % n]);
            rests_on[n].push_back(ring[0]); // and a body on it
            Levels expected(static_cast<std::size_t>(n), 1);
            expected.push_back(2);
            REQUIRE_THAT(contact_levels(rests_on, std::vector<bool>(rests_on.size(), false)),
                         IsExactly(expected));
        }
}

} // namespace rigor::testing
