// SPDX-License-Identifier: MIT
// Opens what lies in a folder that a student may still change. A student who exchanges a folder for
// a link while the grader reads makes it fail, and never makes it read elsewhere.
#pragma once

#include "sandbox/descriptor.hpp"

#include <cstddef>
#include <filesystem>
#include <sys/stat.h>
#include <vector>

namespace rigor {

/// Opens `name`, which is relative to `folder`, as open(2) does with these flags. Links are
/// followed on the way to `folder`, and nowhere in `name`.
/// @throws std::system_error with the errno of the part of the name that cannot be opened
Descriptor opened_beneath(const std::filesystem::path& folder, const std::filesystem::path& name,
                          int flags);

/// The status of `name`, of a link itself and not of what it points to.
/// @throws std::system_error as `opened_beneath`
struct stat status_beneath(const std::filesystem::path& folder, const std::filesystem::path& name);

struct FolderEntry {
    std::filesystem::path name; // without the folder
    mode_t mode = 0;            // 0 if the entry has vanished
};

/// The entries of the folder `name`, which is relative to `folder`, sorted by name. Of a folder
/// with more than `most` entries, any `most` + 1 of them.
/// @throws std::system_error as `opened_beneath`, or if the folder cannot be read
std::vector<FolderEntry> entries_beneath(const std::filesystem::path& folder,
                                         const std::filesystem::path& name, std::size_t most);

} // namespace rigor
