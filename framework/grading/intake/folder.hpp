// SPDX-License-Identifier: MIT
#pragma once

#include "grading/intake/contents.hpp"

#include <filesystem>
#include <string>

namespace rigor {

/// Reads a folder and the folders in it. A link is refused, not followed, also if it has taken the
/// place of the folder itself.
/// @throws Refused if a file cannot be read, or for the same reasons as `read_archive`
Contents read_folder(const std::filesystem::path& folder, const IntakeLimits& limits = {});

/// Reads a source that was handed in without a folder or an archive around it.
/// @param called  the name that the file gets, since Moodle or Canvas may have renamed it
/// @throws Refused as `read_folder`
Contents read_single_file(const std::filesystem::path& file, const std::string& called,
                          const IntakeLimits& limits = {});

} // namespace rigor
