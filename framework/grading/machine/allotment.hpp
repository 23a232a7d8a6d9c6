// SPDX-License-Identifier: MIT
// What this process may use of the machine. A user, a container or Slurm may have given it less
// than there is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace rigor {

/// The numbers of the processors that this process may run on; empty if the kernel does not tell.
std::vector<int> allowed_processors();

/// How many processors this process may use: those that it may run on, or fewer in a task of Slurm,
/// which need not be kept to its own.
unsigned usable_processors();

/// How much memory this process and all that it starts may use [bytes]: a part of the machine's
/// memory as large as that of the processors, or less by the limit of a control group.
std::uint64_t usable_memory();

/// The smallest limit on memory of the control groups, of version 1 or 2, that a process is in
/// [bytes]; the largest number if there is none.
/// @param process  `/proc/self/cgroup`, which lists the groups of a process
/// @param groups  `/sys/fs/cgroup`, which has a folder for each group
std::uint64_t limit_of_groups(const std::filesystem::path& process,
                              const std::filesystem::path& groups);

} // namespace rigor
