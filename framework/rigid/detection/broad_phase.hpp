// SPDX-License-Identifier: MIT
// The broad phase: which pairs of bodies are near enough for the narrow phase.
#pragma once

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/bodies/world.hpp"

namespace rigor {

/// Pairs of bodies whose bounds overlap, in ascending order, by a search among all bodies: a tree of
/// the moving bodies' boxes (overlap_tree.hpp) makes it n log n. Bodies with a plane have no bounds; the
/// distance from the plane to each moving body decides.
///
/// @param poses   of all bodies
/// @param bounds  of all bodies over the step; infinite for those with a plane
std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds, ThreadPool& pool);

/// The same pairs, found among those in the world's pair cache as long as each body stays within its
/// fat bounds there. Changes the cache and the counters.
///
/// @param margins  for each moving body, how much its fat bounds are larger than its bounds [m]
std::vector<BodyPair> cached_near_pairs(World& world, const std::vector<Pose>& poses,
                                        const std::vector<Bounds>& bounds,
                                        const std::vector<double>& margins, ThreadPool& pool);

} // namespace rigor
