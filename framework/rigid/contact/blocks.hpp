// SPDX-License-Identifier: MIT
// Division of a large island into blocks, so that several threads can sweep it at the same time.
#pragma once

#include "rigid/contact/contact_problem.hpp"

namespace rigor {

/// Splits an island of at least 192 bodies into blocks; a smaller island gets a single block. The
/// bodies are divided into vertical slabs. A block holds the pairs whose bodies lie in one slab, or
/// the pairs whose bodies lie in two neighboring slabs. The last block holds the pairs whose bodies
/// lie in slabs farther apart. Blocks of the same color share no moving body (graph coloring).
/// Within a block the pairs keep their order.
///
/// @return the old list `island.pairs` if the island was split, otherwise an empty list
std::vector<ContactPair> split_into_blocks(const ContactProblem& problem, Island& island);

/// Calls work(k) for each block k, one color after the other. Several threads work on different
/// blocks of the same color at the same time.
template <class Work> void visit_blocks(const Island& island, ThreadPool& pool, const Work& work)
{
    for (const IndexRange& color : island.colors)
        pool.for_each_task(color.last - color.first, [&](int k) { work(color.first + k); });
}

} // namespace rigor
