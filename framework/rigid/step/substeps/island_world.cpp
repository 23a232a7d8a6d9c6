// SPDX-License-Identifier: MIT
// Copies an island into a world of its own. First come the bodies that move, then the static bodies
// that contacts or springs connect with them; then their springs, forces, pair laws and warm
// contacts, with the new indices of the bodies.
#include "rigid/step/substeps/island_world.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace rigor {

std::optional<std::vector<int>> bodies_moved_together(const World& world,
                                                      const ContactProblem& problem,
                                                      const Island& island,
                                                      const std::vector<Contact>& near)
{
    std::vector<int> bodies = island.bodies;
    std::vector<bool> is_in(world.bodies.size(), false);
    for (const int i : bodies)
        is_in[i] = true;
    const auto is_other = [&](int i) { return i >= 0 && !world.bodies[i].is_static && !is_in[i]; };
    for (bool grows = !world.springs.empty(); grows;) {
        grows = false;
        for (const Spring& s : world.springs)
            for (const auto& [one, other] : {std::pair(s.body1, s.body2), {s.body2, s.body1}})
                if (one >= 0 && is_in[one] && is_other(other)) {
                    is_in[other] = grows = true;
                    bodies.push_back(other);
                }
    }
    const bool is_pressed =
        std::any_of(world.forces.begin(), world.forces.end(), [&](const AppliedForce& force) {
            return force.is_of_solid && is_in[force.body];
        });
    if (is_pressed) return std::nullopt;
    if (bodies.size() == island.bodies.size()) return bodies;
    for (const Island& each : problem.islands)
        if (&each != &island)
            for (const int i : each.bodies)
                if (is_in[i]) return std::nullopt;
    for (const Contact& c : near)
        if ((is_in[c.body1] && is_other(c.body2)) || (is_in[c.body2] && is_other(c.body1)))
            return std::nullopt;
    std::sort(bodies.begin(), bodies.end());
    return bodies;
}

IslandWorld island_world(const World& world, const std::vector<int>& moved,
                         const std::vector<Contact>& near)
{
    const auto is_moved = [&](int i) { return std::binary_search(moved.begin(), moved.end(), i); };
    IslandWorld part;
    part.bodies = moved;
    for (const Contact& c : near)
        for (const auto& [fixed, other] :
             {std::pair(c.body1, c.body2), std::pair(c.body2, c.body1)})
            if (world.bodies[fixed].is_static && is_moved(other)) part.bodies.push_back(fixed);
    std::vector<Spring> springs;
    for (const Spring& spring : world.springs) {
        if (!is_moved(spring.body1) && !is_moved(spring.body2)) continue;
        springs.push_back(spring);
        for (const int i : {spring.body1, spring.body2})
            if (i >= 0) part.bodies.push_back(i);
    }
    std::sort(part.bodies.begin(), part.bodies.end());
    part.bodies.erase(std::unique(part.bodies.begin(), part.bodies.end()), part.bodies.end());

    std::map<int, int> index;
    for (int i : part.bodies) {
        index[i] = static_cast<int>(part.world.bodies.size());
        part.world.bodies.push_back(world.bodies[i]);
    }
    for (Spring spring : springs) {
        if (spring.body1 >= 0) spring.body1 = index[spring.body1];
        if (spring.body2 >= 0) spring.body2 = index[spring.body2];
        part.world.springs.push_back(spring);
    }
    for (AppliedForce force : world.forces)
        if (is_moved(force.body)) {
            force.body = index[force.body];
            part.world.forces.push_back(force);
        }
    part.world.pair_laws = laws_among(world.pair_laws, part.bodies);
    part.world.settings = world.settings;
    part.world.settings.optimisations.sleep = false;
    part.world.time = world.time;
    part.world.counters = world.counters;
    for (WarmContact warm : world.memory.warm_contacts) {
        const auto body1 = index.find(warm.body1), body2 = index.find(warm.body2);
        if (body1 == index.end() || body2 == index.end()) continue;
        warm.body1 = body1->second;
        warm.body2 = body2->second;
        part.world.memory.warm_contacts.push_back(warm);
    }
    return part;
}

} // namespace rigor
