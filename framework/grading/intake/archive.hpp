// SPDX-License-Identifier: MIT
// Archives as students hand them in: .zip, and .tar, compressed or not.
#pragma once

#include "grading/intake/contents.hpp"

#include <string>
#include <string_view>

namespace rigor {

/// Whether a file's name ends like that of an archive. This includes formats that cannot be read
/// here, such as .rar.
bool is_archive_name(std::string_view name);

/// The name without the ending of an archive: "alice" for "alice.tar.gz".
std::string without_archive_ending(std::string_view name);

/// Reads a whole archive from a descriptor. Nothing is written to the disk. The library that reads
/// the archive may have security holes, so archives of students are read in a sandbox, by
/// `read_archive_behind_walls` (unpacked.hpp).
/// @throws Refused if the archive is broken or encrypted, holds anything but files and folders, has
///     a name with ".." or the same name twice, or exceeds a limit
Contents read_archive(int descriptor, const IntakeLimits& limits = {});

} // namespace rigor
