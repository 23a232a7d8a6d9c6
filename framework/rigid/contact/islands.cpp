// SPDX-License-Identifier: MIT
// Finds islands, which are groups of bodies connected by contacts, by union–find over the pairs of
// moving bodies. The contacts are first grouped into pairs of bodies, and the pairs are sorted by
// height. Then each pair is added to the island of its moving body or bodies. Islands in which no
// bodies would penetrate in this step are left out.
#include "rigid/contact/islands.hpp"

#include "rigid/bodies/height_order.hpp"
#include "rigid/bodies/union_find.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace rigor {

namespace {

// A body of the contact that is not static: body 1, or body 2 if body 1 is static.
int moving_of(const World& world, const Contact& c)
{
    return world.bodies[c.body1].is_static ? c.body2 : c.body1;
}

} // namespace

std::vector<ContactPair> pairs_of(std::span<const ContactConstraint> contacts)
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

void sort_by_height(const ContactProblem& problem, std::vector<ContactPair>& pairs)
{
    if (pairs.size() < 2) return;
    struct Sortable {
        HeightOrder::Key lowest; // sort key of the pair's lowest contact
        ContactPair pair;
    };
    const auto lowest_of = [&](const ContactPair& pair) -> const Vector3d& {
        return problem.contacts[pair.first].point;
    };
    const HeightOrder key_of(problem.settings.gravity, pairs, lowest_of);
    std::vector<Sortable> sortable;
    sortable.reserve(pairs.size());
    for (const ContactPair& pair : pairs)
        sortable.push_back({key_of(lowest_of(pair)), pair});
    std::sort(sortable.begin(), sortable.end(), [](const Sortable& a, const Sortable& b) {
        return a.lowest < b.lowest || (a.lowest == b.lowest && a.pair.first < b.pair.first);
    });
    std::transform(sortable.begin(), sortable.end(), pairs.begin(),
                   [](const Sortable& p) { return p.pair; });
}

std::vector<Island> islands_of(const World& world, const ContactProblem& problem,
                               const std::vector<ContactPair>& pairs)
{
    UnionFind groups(world.bodies.size());
    for (const ContactPair& pair : pairs) {
        const ContactConstraint& c = problem.contacts[pair.first];
        if (!world.bodies[c.body1].is_static && !world.bodies[c.body2].is_static)
            groups.unite(c.body1, c.body2);
    }
    if (!world.settings.optimisations.islands) // then all bodies with contacts form one island
        for (const ContactConstraint& c : problem.contacts)
            for (int i : {c.body1, c.body2})
                if (!world.bodies[i].is_static)
                    groups.unite(moving_of(world, problem.contacts[0]), i);

    std::vector<int> island_of(world.bodies.size(), -1);
    std::vector<bool> is_active;
    std::vector<Island> islands;
    for (const ContactPair& pair : pairs) {
        const ContactConstraint& first = problem.contacts[pair.first];
        int& island = island_of[groups.find(moving_of(world, first))];
        if (island < 0) {
            island = static_cast<int>(islands.size());
            islands.emplace_back();
            is_active.push_back(false);
        }
        islands[island].pairs.push_back(pair);
        for (int i = pair.first; i < pair.last && !is_active[island]; ++i) {
            const ContactConstraint& c = problem.contacts[i];
            is_active[island] = problem.predicted_gap(c, c.free_speed) < problem.bend_of_drives(c);
        }
    }
    for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
        if (const int island = island_of[groups.find(i)]; island >= 0 && !world.bodies[i].is_static)
            islands[island].bodies.push_back(i);

    std::size_t active = 0;
    for (std::size_t i = 0; i < islands.size(); ++i)
        if (is_active[i] && active++ != i) islands[active - 1] = std::move(islands[i]);
    islands.resize(active);
    return islands;
}

} // namespace rigor
