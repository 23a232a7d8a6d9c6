// SPDX-License-Identifier: MIT
// Reads a file that a student handed in. Whatever the student put in its place, such as a link, a
// pipe or a device, the grader reads no other file, waits for nobody, and reads no more than it
// asked for. Every room that opens a file of a submission does it here.
#pragma once

#include "sandbox/descriptor.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <sys/types.h>

namespace rigor {

/// What this is if it is neither a file nor a folder, such as "a link"; otherwise empty.
std::string_view special_kind(mode_t mode);

/// Opens a plain file for reading: `name` in `folder`, as `opened_beneath` opens it. Its kind is
/// asked of the open file, so that nobody can exchange the file between the check and the reading.
/// @throws Refused if it is anything but a plain file, or cannot be opened; without its name
Descriptor opened_plain_file(const std::filesystem::path& folder,
                             const std::filesystem::path& name);

struct PlainFile {
    std::size_t size = 0; // [bytes]
    std::string text;     // empty if the file is larger than the limit
};

/// Reads a plain file of at most `most` bytes. Of a larger one, which may be of any size without
/// taking space on a disk, only the size is read.
/// @throws Refused as `opened_plain_file`
PlainFile read_plain_file(const std::filesystem::path& folder, const std::filesystem::path& name,
                          std::size_t most);

} // namespace rigor
