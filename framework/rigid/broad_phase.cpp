// SPDX-License-Identifier: MIT
#include "rigid/broad_phase.hpp"

#include "geometry/box_tree.hpp"

#include <algorithm>
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

// Ascending, by counting the pairs of each body 1.
std::vector<BodyPair> in_order(const std::vector<BodyPair>& pairs, std::size_t bodies)
{
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

} // namespace

std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds, Counters& counters)
{
    std::vector<int> moving, still, endless;
    std::uint64_t fixed = 0;
    const int n = static_cast<int>(world.bodies.size());
    for (int i = 0; i < n; ++i) {
        const bool is_static = world.bodies[i].is_static, is_still = world.bodies[i].is_still();
        const bool is_bounded = bounds[i].high.allFinite();
        (!is_bounded ? endless : is_still ? still : moving).push_back(i);
        fixed += is_static;
    }
    const auto pairs_among = [](std::uint64_t bodies) {
        return bodies < 2 ? 0 : bodies * (bodies - 1) / 2;
    };
    counters.pairs_possible += pairs_among(world.bodies.size()) - pairs_among(fixed);

    std::vector<BodyPair> pairs;
    const auto add = [&pairs](int i, int j) { pairs.push_back({std::min(i, j), std::max(i, j)}); };
    const BoxTree tree(bounds, moving);
    tree.for_each_pair(add);
    for (int i : still)
        tree.for_each_overlap(bounds[i], [&](int j) { add(i, j); });
    for (int i : endless)
        for (int j : moving)
            if (reaches(world.bodies[i], poses[i], bounds[j])) add(i, j);
    return in_order(pairs, world.bodies.size());
}

} // namespace rigor
