// SPDX-License-Identifier: MIT
#pragma once

#include "release/tree.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// The bytes of a zip archive with these files. The same files give the same bytes.
std::string zip_of(const ReleasedTree& tree);

/// The files of a zip archive. @throws std::runtime_error if it is broken
ReleasedTree unzipped(const std::filesystem::path& file);

} // namespace rigor
