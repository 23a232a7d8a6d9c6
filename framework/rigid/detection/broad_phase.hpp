// SPDX-License-Identifier: MIT
// The broad phase: finds the pairs of bodies that are near enough for the narrow phase.
#pragma once

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"

namespace rigor {

/// The pairs of bodies whose bounds overlap and of which at least one body moves, sorted by
/// `body1`, then `body2`. They are found by a search among all bodies. With a tree of the moving
/// bodies' bounds (overlap_tree.hpp), the cost for n bodies grows as n log n. Bodies with a plane
/// have no finite bounds; for them, the function tests whether any of their parts reaches the
/// bounds of each moving body.
///
/// @param poses   the poses of all bodies
/// @param bounds  the bounds of all bodies over the step; infinite for bodies with a plane
std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds, ThreadPool& pool);

/// Returns the same pairs as `near_pairs`. As long as each body stays within its fat bounds
/// (enlarged bounds, pair_cache.hpp), only the pairs of the cache are tested. Changes the world's
/// pair cache and its counters.
///
/// @param margins  for each body, the distance by which new fat bounds exceed its bounds on each
///                 side [m]; used only for moving bodies
std::vector<BodyPair> cached_near_pairs(World& world, const std::vector<Pose>& poses,
                                        const std::vector<Bounds>& bounds,
                                        const std::vector<double>& margins, ThreadPool& pool);

} // namespace rigor
