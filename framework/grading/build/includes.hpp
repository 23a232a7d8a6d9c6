// SPDX-License-Identifier: MIT
// Checks what a solution includes. It may include the headers of framework/formulas (the contract),
// files of its own folder, and system headers. Where the sandbox has namespaces or Landlock, the
// compiler cannot open other files anyway.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rigor {

/// An error message of one line if a forbidden file is in the compiler's list of what it opened;
/// otherwise empty. All files of this tree and of its build are forbidden, by whatever path, macro
/// or link they were included, except those in `folder`, the contract (framework/formulas/), the
/// precompiled header of Eigen, and no_file_queries.hpp. A file that does not exist any more is
/// forbidden too.
/// @param list    the compiler's list, `<topic>.d`
/// @param folder  the compiler's working directory, where the solution's files are
/// @throws std::runtime_error if there is no list
std::string forbidden_include(const std::filesystem::path& list,
                              const std::filesystem::path& folder);

/// Whether the compiler's list has one of these files of `folder`.
bool includes_one_of(const std::vector<std::string>& names, const std::filesystem::path& list,
                     const std::filesystem::path& folder);

} // namespace rigor
