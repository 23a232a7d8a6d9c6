// SPDX-License-Identifier: MIT
#include "rigid/broad_phase.hpp"

#include "geometry/bounds/overlap_tree.hpp"
#include "geometry/shapes/shape_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

// Whether anything of a body without bounds comes near `bounds`.
bool reaches(const RigidBody& endless, const Pose& pose, const Bounds& bounds)
{
    const Vector3d center = (bounds.low + bounds.high) / 2;
    const Vector3d extent = (bounds.high - bounds.low) / 2;
    return std::any_of(endless.parts.begin(), endless.parts.end(), [&](const Part& part) {
        const Pose placed = part_pose(pose, part);
        if (!is_plane(part)) return bounds.overlaps(bounds_of(part.shape, placed));
        const Vector3d n = placed.R.col(1);
        return n.dot(center - placed.X) - n.cwiseAbs().dot(extent) <= 0;
    });
}

constexpr std::size_t few = 12; // trees and counting pay for more

BodyPair pair_of(int i, int j)
{
    return {std::min(i, j), std::max(i, j)};
}

// Ascending, by counting the pairs of each body 1.
std::vector<BodyPair> in_order(std::vector<BodyPair> pairs, std::size_t bodies)
{
    if (pairs.size() <= few) {
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }
    std::vector<std::size_t> first(bodies + 1, 0);
    for (const BodyPair& pair : pairs)
        ++first[static_cast<std::size_t>(pair.body1) + 1];
    for (std::size_t i = 0; i < bodies; ++i)
        first[i + 1] += first[i];
    std::vector<BodyPair> sorted(pairs.size());
    std::vector<std::size_t> next = first;
    for (const BodyPair& pair : pairs)
        sorted[next[pair.body1]++] = pair;
    for (std::size_t i = 0; i < bodies; ++i)
        std::sort(sorted.begin() + static_cast<std::ptrdiff_t>(first[i]),
                  sorted.begin() + static_cast<std::ptrdiff_t>(first[i + 1]));
    return sorted;
}

// In an order that depends on the number of threads: they are put in order later.
std::vector<BodyPair> overlapping(const OverlapTree& tree, std::size_t members, Team& team)
{
    constexpr std::size_t worth_sharing = 128; // members
    const int stretches = team.stretches_of(members, worth_sharing);
    if (stretches == 0) return {};
    constexpr std::size_t parts_a_stretch = 4; // they are not all the same size
    const std::vector<OverlapTree::NodePair> parts =
        tree.parts(stretches < 2 ? 1 : parts_a_stretch * static_cast<std::size_t>(stretches));
    std::vector<std::vector<BodyPair>> found(stretches);
    team.share(stretches, [&](int k) {
        const auto [first, last] = Team::stretch(parts.size(), stretches, k);
        for (std::size_t part = first; part < last; ++part)
            tree.for_each_pair(parts[part],
                               [&](int i, int j) { found[k].push_back(pair_of(i, j)); });
    });
    for (std::size_t k = 1; k < found.size(); ++k)
        found[0].insert(found[0].end(), found[k].begin(), found[k].end());
    return std::move(found[0]);
}

std::vector<BodyPair> by_a_tree(const std::vector<Bounds>& bounds, const std::vector<int>& moving,
                                const std::vector<int>& still, Team& team)
{
    constexpr std::size_t worth_sharing = 256; // members
    const auto parts = static_cast<std::size_t>(team.stretches_of(moving.size(), worth_sharing));
    const OverlapTree tree(bounds, moving, parts,
                           [&team](int tasks, const auto& build) { team.share(tasks, build); });
    std::vector<BodyPair> pairs = overlapping(tree, moving.size(), team);
    for (int i : still)
        tree.for_each_overlap(bounds[i], [&](int j) { pairs.push_back(pair_of(i, j)); });
    return pairs;
}

std::vector<BodyPair> compare_all(const std::vector<Bounds>& bounds, const std::vector<int>& moving,
                                  const std::vector<int>& still)
{
    std::vector<BodyPair> pairs;
    for (auto i = moving.begin(); i != moving.end(); ++i) {
        for (auto j = i + 1; j != moving.end(); ++j)
            if (bounds[*i].overlaps(bounds[*j])) pairs.push_back(pair_of(*i, *j));
        for (int j : still)
            if (bounds[*i].overlaps(bounds[j])) pairs.push_back(pair_of(*i, j));
    }
    return pairs;
}

using Kind = PairMemory::Kind;

Kind kind_of(const RigidBody& body, const Bounds& bounds)
{
    if (!bounds.high.allFinite()) return Kind::endless;
    return body.is_still() ? Kind::still : Kind::moving;
}

// Of which one is not static.
std::uint64_t pairs_possible(const World& world)
{
    const auto among = [](std::uint64_t bodies) {
        return bodies < 2 ? 0 : bodies * (bodies - 1) / 2;
    };
    const auto fixed = std::count_if(world.bodies.begin(), world.bodies.end(),
                                     [](const RigidBody& body) { return body.is_static; });
    return among(world.bodies.size()) - among(static_cast<std::uint64_t>(fixed));
}

// Whether all bodies are of the kinds that they were, and in their rooms.
bool is_valid(const PairMemory& memory, const World& world, const std::vector<Bounds>& bounds)
{
    if (memory.rooms.size() != bounds.size()) return false;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Kind kind = kind_of(world.bodies[i], bounds[i]);
        if (kind != memory.kinds[i]) return false;
        if (kind != Kind::endless && !memory.rooms[i].contains(bounds[i])) return false;
    }
    return true;
}

} // namespace

std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds, Counters& counters, Team& team)
{
    std::array<std::vector<int>, 3> members; // of each kind
    for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
        members[static_cast<int>(kind_of(world.bodies[i], bounds[i]))].push_back(i);
    counters.pairs_possible += pairs_possible(world);

    const auto& [moving, still, endless] = members;
    std::vector<BodyPair> pairs = moving.size() <= few ? compare_all(bounds, moving, still)
                                                       : by_a_tree(bounds, moving, still, team);
    for (int i : endless)
        for (int j : moving)
            if (reaches(world.bodies[i], poses[i], bounds[j])) pairs.push_back(pair_of(i, j));
    return in_order(std::move(pairs), world.bodies.size());
}

std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds,
                                 const std::vector<double>& spare, PairMemory& memory,
                                 Counters& counters, Team& team)
{
    constexpr std::size_t worth_remembering = 64; // bodies
    if (bounds.size() < worth_remembering) return near_pairs(world, poses, bounds, counters, team);

    counters.pairs_possible += pairs_possible(world);
    if (is_valid(memory, world, bounds)) {
        ++counters.pair_searches_saved;
    } else {
        memory.rooms = bounds;
        memory.kinds.resize(bounds.size());
        for (std::size_t i = 0; i < bounds.size(); ++i) {
            memory.kinds[i] = kind_of(world.bodies[i], bounds[i]);
            if (memory.kinds[i] == Kind::moving) memory.rooms[i].grow(spare[i]);
        }
        Counters uncounted;
        memory.pairs = near_pairs(world, poses, memory.rooms, uncounted, team);
    }
    const auto come_near = [&](int i, int j) {
        return memory.kinds[i] == Kind::endless ? reaches(world.bodies[i], poses[i], bounds[j])
                                                : bounds[i].overlaps(bounds[j]);
    };
    std::vector<BodyPair> pairs;
    pairs.reserve(memory.pairs.size());
    for (const BodyPair& pair : memory.pairs) {
        const auto [i, j] = pair;
        if (memory.kinds[j] == Kind::endless ? come_near(j, i) : come_near(i, j))
            pairs.push_back(pair);
    }
    return pairs;
}

} // namespace rigor
