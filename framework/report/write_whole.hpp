// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace rigor {

/// The name that a file has while it is written, beside its place: "result.json.new". No other file
/// or folder may have this name.
std::filesystem::path draft_of(const std::filesystem::path& file);

/// Writes a file whole or not at all: no half-written file is left behind under its name.
/// @throws InputError if it cannot be written
void write_whole(const std::filesystem::path& file, const std::string& content);

} // namespace rigor
