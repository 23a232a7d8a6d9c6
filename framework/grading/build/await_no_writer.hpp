// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace rigor {

/// Waits, for at most 10 s, until no process has the file open for writing, because a program that
/// is open for writing cannot be started ("text file busy"). Such a process may be a child that
/// another thread has forked: until it starts its own program, it has copies of all descriptors of
/// this process.
///
/// @param file  a file that this user owns; on a file system without leases, the function does not
///     wait
void await_no_writer(const std::filesystem::path& file);

} // namespace rigor
