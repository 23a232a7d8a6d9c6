// SPDX-License-Identifier: MIT
// An island that is too large for one thread, in parts that can be swept at the same time.
#pragma once

#include "rigid/contact_problem.hpp"

namespace rigor {

/// Puts the pairs of an island in blocks if it has many bodies: its bodies are divided into upright slabs, and a
/// block is the pairs within a slab, or between two neighbours. Blocks of a stage share no body that moves. Within
/// a block the pairs keep their order. @return the pairs that were replaced, if any
std::vector<ContactPair> split_into_blocks(const ContactProblem& problem, Island& island);

/// Calls work(k) for each block, one after the other or by several threads where the result cannot tell.
template <class Work> void visit_blocks(const Island& island, Team& team, const Work& work)
{
    for (const IslandStretch& stage : island.stages)
        team.share(stage.last - stage.first, [&](int k) { work(stage.first + k); });
}

} // namespace rigor
