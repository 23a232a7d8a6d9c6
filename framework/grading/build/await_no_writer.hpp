// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace rigor {

/// Waits, for at most 10 s, until no process has the file open for writing, because a program that
/// is open for writing cannot be started ("text file busy"). A child that another thread has forked
/// keeps the descriptors of this process until it starts its program, and so may keep the file
/// open.
///
/// @param file  a file that this user owns; on a file system without leases, the function does not
///     wait
void await_no_writer(const std::filesystem::path& file);

} // namespace rigor
