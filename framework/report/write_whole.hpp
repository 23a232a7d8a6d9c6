// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace rigor {

/// Writes a file whole or not at all: no half-written file is left behind under its name.
/// @throws InputError if it cannot be written
void write_whole(const std::filesystem::path& file, const std::string& content);

} // namespace rigor
