// SPDX-License-Identifier: MIT
// Permissions of what another user reads, which the umask may have left out. Paths whose
// permissions cannot be changed stay as they are: whoever reads them reports that.
#pragma once

#include <filesystem>

namespace rigor {

/// Lets every user read a file, or a folder with its files. Links stay as they are, since they may
/// lead to a file that is not to be read.
void let_others_read(const std::filesystem::path& path);

/// Lets every user pass through those folders around a path that belong to the tree or its build.
void let_others_pass(const std::filesystem::path& path);

} // namespace rigor
