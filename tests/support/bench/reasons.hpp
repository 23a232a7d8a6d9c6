// SPDX-License-Identifier: MIT
// A file of exceptions, each with its reason. A reason is a paragraph of lines that begin with `#`.
// The names that it is the reason for follow it, one in each line.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace rigor::testing {

/// The names in the file, each with its reason.
/// @throws std::runtime_error if the file cannot be read, or has a name twice or without a reason
std::map<std::string, std::string> reasons_in(const std::filesystem::path& file);

} // namespace rigor::testing
