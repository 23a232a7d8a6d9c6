// SPDX-License-Identifier: MIT
#pragma once

#include "grading/intake/contents.hpp"

#include <filesystem>

namespace rigor {

/// Reads a folder and the folders in it. Links are not followed.
/// @throws Refused if a file cannot be read, or for the same reasons as `read_archive`
Contents read_folder(const std::filesystem::path& folder, const IntakeLimits& limits = {});

} // namespace rigor
