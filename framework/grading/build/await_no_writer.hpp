// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace rigor {

/// Waits until no process has the file open for writing, because a program that is open for writing
/// cannot be started ("text file busy"). A process that another thread is about to start has, for a
/// moment, all descriptors of this one.
///
/// @param file  a file of this user; on a file system that cannot tell, nothing is waited for
void await_no_writer(const std::filesystem::path& file);

} // namespace rigor
