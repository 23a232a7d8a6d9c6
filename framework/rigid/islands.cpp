// SPDX-License-Identifier: MIT
#include "rigid/islands.hpp"

#include "rigid/from_lowest.hpp"
#include "rigid/groups.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

int moving_of(const World& world, const Contact& c)
{
    return world.bodies[c.body1].is_static ? c.body2 : c.body1;
}

} // namespace

std::vector<ContactPair> pairs_of(std::span<const SolvedContact> contacts)
{
    std::vector<ContactPair> pairs;
    for (int first = 0, last = 0, n = static_cast<int>(contacts.size()); first < n; first = last) {
        while (last < n && contacts[last].body1 == contacts[first].body1 &&
               contacts[last].body2 == contacts[first].body2)
            ++last;
        pairs.push_back({first, last});
    }
    return pairs;
}

void sort_from_lowest(const ContactProblem& problem, std::vector<ContactPair>& pairs)
{
    if (pairs.size() < 2) return;
    struct Placed {
        FromLowest::Place lowest; // contact
        ContactPair pair;
    };
    const auto lowest_of = [&](const ContactPair& pair) -> const Vector3d& {
        return problem.contacts[pair.first].point;
    };
    const FromLowest place_of(problem.gravity, pairs, lowest_of);
    const auto is_lower = [](const Placed& a, const Placed& b) {
        return std::pair(a.lowest, a.pair.first) < std::pair(b.lowest, b.pair.first);
    };
    std::vector<Placed> placed(pairs.size());
    const auto sort_from = [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            placed[k] = {place_of(lowest_of(pairs[k])), pairs[k]};
        std::sort(placed.begin() + static_cast<std::ptrdiff_t>(first),
                  placed.begin() + static_cast<std::ptrdiff_t>(last), is_lower);
    };
    constexpr std::size_t worth_sharing = 512; // pairs
    const std::size_t n = placed.size(), middle = n / 2;
    problem.team->share_both(
        n, worth_sharing, [&] { sort_from(0, middle); }, [&] { sort_from(middle, n); });
    std::inplace_merge(placed.begin(), placed.begin() + static_cast<std::ptrdiff_t>(middle),
                       placed.end(), is_lower);
    std::transform(placed.begin(), placed.end(), pairs.begin(),
                   [](const Placed& p) { return p.pair; });
}

std::vector<Island> islands_of(const World& world, const ContactProblem& problem,
                               const std::vector<ContactPair>& pairs)
{
    Groups groups(world.bodies.size());
    for (const ContactPair& pair : pairs) {
        const SolvedContact& c = problem.contacts[pair.first];
        if (!world.bodies[c.body1].is_static && !world.bodies[c.body2].is_static)
            groups.join(c.body1, c.body2);
    }
    if (!world.skips.islands) // all in one
        for (const SolvedContact& c : problem.contacts)
            for (int i : {c.body1, c.body2})
                if (!world.bodies[i].is_static)
                    groups.join(moving_of(world, problem.contacts[0]), i);

    std::vector<int> island_of(world.bodies.size(), -1);
    std::vector<bool> is_active;
    std::vector<Island> islands;
    for (const ContactPair& pair : pairs) {
        const SolvedContact& first = problem.contacts[pair.first];
        int& island = island_of[groups.of(moving_of(world, first))];
        if (island < 0) {
            island = static_cast<int>(islands.size());
            islands.emplace_back();
            is_active.push_back(false);
        }
        islands[island].pairs.push_back(pair);
        for (int i = pair.first; i < pair.last && !is_active[island]; ++i) {
            const SolvedContact& c = problem.contacts[i];
            is_active[island] = problem.predicted_gap(c, c.free_speed) < 0;
        }
    }
    for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
        if (const int island = island_of[groups.of(i)]; island >= 0 && !world.bodies[i].is_static)
            islands[island].bodies.push_back(i);

    std::vector<Island> active;
    for (std::size_t i = 0; i < islands.size(); ++i)
        if (is_active[i]) active.push_back(std::move(islands[i]));
    return active;
}

std::size_t contacts_of(std::span<const ContactPair> pairs)
{
    return std::accumulate(
        pairs.begin(), pairs.end(), std::size_t{0},
        [](std::size_t sum, const ContactPair& pair) { return sum + pair.count(); });
}

bool is_heap(const Island& island)
{
    constexpr std::size_t few_bodies = 8, many_bodies = 256;
    const std::size_t bodies = island.bodies.size(), pairs = island.pairs.size();
    return bodies > few_bodies && (bodies > many_bodies || 4 * pairs > 5 * bodies + 8);
}

} // namespace rigor
