// SPDX-License-Identifier: MIT
// Compilers and linkers take turns, so that those that run at a time find processors and memory.
#pragma once

#include "sandbox/descriptor.hpp"

#include <cstdint>

namespace rigor {

/// How many tools may run at a time, and the limit on the memory of each [bytes]. A compiler and
/// its assembler are one tool, but each of them may use this memory.
struct ToolShare {
    unsigned at_once = 1;
    std::uint64_t memory = 0;
};

/// The share of a tool where all of them together may use so many processors and so much memory
/// [bytes]. Each gets the memory that every right file needs, so where this is scarce, fewer of
/// them run at a time.
ToolShare tool_share(unsigned processors, std::uint64_t memory);

/// The share of a tool of this process and of the processes that have its turns.
const ToolShare& own_tool_share();

/// Makes the turns, if there are none yet. Processes that are forked afterwards take turns with
/// this one.
/// @throws InputError if the machine has no memory for that
void make_tool_turns();

/// The permission to run one tool, as long as this object lives. The kernel takes it back from a
/// process that ends.
class ToolTurn {
public:
    /// Waits until fewer than `ToolShare::at_once` tools run.
    ToolTurn();

private:
    Descriptor lock_;
};

} // namespace rigor
