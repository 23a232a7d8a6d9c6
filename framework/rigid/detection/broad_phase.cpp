// SPDX-License-Identifier: MIT
// The broad phase. If there are few moving bodies, they are compared pair by pair. If there are
// many, several threads search a tree of the moving bodies' bounds for overlaps. Bodies with a
// plane are compared with all moving bodies. A cache of fat bounds (Verlet 1967) keeps the pairs
// valid over several steps.
#include "rigid/detection/broad_phase.hpp"

#include "geometry/bounds/overlap_tree.hpp"
#include "geometry/shapes/shape_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {

namespace {

// Whether any part of a body without finite bounds (one that has a plane) overlaps `bounds`.
bool reaches(const RigidBody& unbounded, const Pose& pose, const Bounds& bounds)
{
    const Vector3d center = (bounds.low + bounds.high) / 2;
    const Vector3d extent = (bounds.high - bounds.low) / 2;
    return std::any_of(unbounded.parts.begin(), unbounded.parts.end(), [&](const Part& part) {
        const Pose placed = part_pose(pose, part);
        if (!is_plane(part)) return bounds.overlaps(bounds_of(part.shape, placed));
        const Vector3d n = placed.R.col(1);
        return n.dot(center - placed.X) - n.cwiseAbs().dot(extent) <= 0;
    });
}

// Up to this many moving bodies are compared pair by pair, without a tree, and up to this many
// pairs are sorted without a counting sort, because this is faster. The value was chosen by trial;
// no result depends on it.
constexpr std::size_t few = 12;

BodyPair pair_of(int i, int j)
{
    return {std::min(i, j), std::max(i, j)};
}

// Sorts the pairs by `body1`, then `body2`. If there are many, a counting sort on `body1` comes
// first.
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

// The pairs of bodies whose bounds overlap in the tree, in an order that depends on the number of
// threads; `in_order` sorts them later.
std::vector<BodyPair> overlapping(const OverlapTree& tree, std::size_t members, ThreadPool& pool)
{
    constexpr std::size_t grain_size = 128; // least number of bodies in one parallel task
    const int ranges = pool.range_count(members, grain_size);
    if (ranges == 0) return {};
    constexpr std::size_t parts_per_range = 4; // several, since parts differ in size
    const std::vector<OverlapTree::NodePair> parts =
        tree.parts(ranges < 2 ? 1 : parts_per_range * static_cast<std::size_t>(ranges));
    std::vector<std::vector<BodyPair>> found(ranges);
    pool.for_each_task(ranges, [&](int k) {
        const auto [first, last] = ThreadPool::range(parts.size(), ranges, k);
        for (std::size_t part = first; part < last; ++part)
            tree.for_each_pair(parts[part],
                               [&](int i, int j) { found[k].push_back(pair_of(i, j)); });
    });
    for (std::size_t k = 1; k < found.size(); ++k)
        found[0].insert(found[0].end(), found[k].begin(), found[k].end());
    return std::move(found[0]);
}

std::vector<BodyPair> search_tree(const std::vector<Bounds>& bounds, const std::vector<int>& moving,
                                  const std::vector<int>& still, ThreadPool& pool)
{
    constexpr std::size_t grain_size = 256; // least number of bodies in one parallel task
    const auto parts = static_cast<std::size_t>(pool.range_count(moving.size(), grain_size));
    const OverlapTree tree(bounds, moving, parts, [&pool](int tasks, const auto& build) {
        pool.for_each_task(tasks, build);
    });
    std::vector<BodyPair> pairs = overlapping(tree, moving.size(), pool);
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

using Kind = PairCache::Kind;

Kind kind_of(const RigidBody& body, const Bounds& bounds)
{
    if (!bounds.high.allFinite()) return Kind::unbounded;
    return body.is_still() ? Kind::still : Kind::moving;
}

// The number of pairs in which at least one body is not static.
std::uint64_t pairs_possible(const World& world)
{
    const auto among = [](std::uint64_t bodies) {
        return bodies < 2 ? 0 : bodies * (bodies - 1) / 2;
    };
    const auto fixed = std::count_if(world.bodies.begin(), world.bodies.end(),
                                     [](const RigidBody& body) { return body.is_static; });
    return among(world.bodies.size()) - among(static_cast<std::uint64_t>(fixed));
}

// Whether the pairs of the cache are valid: each body has the same kind as when the pairs were
// found, and its bounds lie within its fat bounds.
bool is_valid(const PairCache& cache, const World& world, const std::vector<Bounds>& bounds)
{
    if (cache.fat_bounds.size() != bounds.size()) return false;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Kind kind = kind_of(world.bodies[i], bounds[i]);
        if (kind != cache.kinds[i]) return false;
        if (kind != Kind::unbounded && !cache.fat_bounds[i].contains(bounds[i])) return false;
    }
    return true;
}

} // namespace

std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds, ThreadPool& pool)
{
    std::array<std::vector<int>, 3> members; // one list for each kind
    for (int i = 0; i < static_cast<int>(world.bodies.size()); ++i)
        members[static_cast<int>(kind_of(world.bodies[i], bounds[i]))].push_back(i);

    const auto& [moving, still, unbounded] = members;
    std::vector<BodyPair> pairs = moving.size() <= few ? compare_all(bounds, moving, still)
                                                       : search_tree(bounds, moving, still, pool);
    for (int i : unbounded)
        for (int j : moving)
            if (reaches(world.bodies[i], poses[i], bounds[j])) pairs.push_back(pair_of(i, j));
    return in_order(std::move(pairs), world.bodies.size());
}

std::vector<BodyPair> cached_near_pairs(World& world, const std::vector<Pose>& poses,
                                        const std::vector<Bounds>& bounds,
                                        const std::vector<double>& margins, ThreadPool& pool)
{
    // With fewer bodies than this, a new search takes less time than the check of the cache. The
    // value was chosen by trial; no result depends on it.
    constexpr std::size_t worth_caching = 64;
    world.counters.pairs_possible += pairs_possible(world);
    if (bounds.size() < worth_caching) return near_pairs(world, poses, bounds, pool);

    PairCache& cache = world.memory.pairs;
    if (is_valid(cache, world, bounds)) {
        ++world.counters.pair_searches_saved;
    } else {
        cache.fat_bounds = bounds;
        cache.kinds.resize(bounds.size());
        for (std::size_t i = 0; i < bounds.size(); ++i) {
            cache.kinds[i] = kind_of(world.bodies[i], bounds[i]);
            if (cache.kinds[i] == Kind::moving) cache.fat_bounds[i].grow(margins[i]);
        }
        cache.pairs = near_pairs(world, poses, cache.fat_bounds, pool);
    }
    const auto come_near = [&](int i, int j) {
        return cache.kinds[i] == Kind::unbounded ? reaches(world.bodies[i], poses[i], bounds[j])
                                                 : bounds[i].overlaps(bounds[j]);
    };
    std::vector<BodyPair> pairs;
    pairs.reserve(cache.pairs.size());
    for (const BodyPair& pair : cache.pairs) {
        const auto [i, j] = pair;
        if (cache.kinds[j] == Kind::unbounded ? come_near(j, i) : come_near(i, j))
            pairs.push_back(pair);
    }
    return pairs;
}

} // namespace rigor
