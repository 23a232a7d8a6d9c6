// SPDX-License-Identifier: MIT
// Which bodies are near enough to look at closely.
#pragma once

#include "geometry/bounds/bounds.hpp"
#include "geometry/shapes/pose.hpp"
#include "rigid/team.hpp"
#include "rigid/world.hpp"

namespace rigor {

/// Pairs of bodies whose bounds overlap, in ascending order.
///
/// By a tree of the moving bodies' boxes (box_tree.hpp), n log n. Bodies with a plane have no bounds:
/// they are held against each moving body, a distance each.
///
/// @param poses   of all bodies
/// @param bounds  of all bodies over the step; infinite for those with a plane
std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds, Counters& counters, Team& team);

/// The same by the calling thread alone.
inline std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                        const std::vector<Bounds>& bounds, Counters& counters)
{
    Team alone;
    return near_pairs(world, poses, bounds, counters, alone);
}

/// The same pairs, found among those that the memory has, as long as each body stays in its room there.
///
/// @param spare  for each body that moves, how much larger than its bounds to make its room [m]
std::vector<BodyPair> near_pairs(const World& world, const std::vector<Pose>& poses,
                                 const std::vector<Bounds>& bounds,
                                 const std::vector<double>& spare, PairMemory& memory,
                                 Counters& counters, Team& team);

} // namespace rigor
