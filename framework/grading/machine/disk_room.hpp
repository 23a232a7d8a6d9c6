// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace rigor {

/// Checks that the owner of a folder can make a file of this size there [bytes], and not only root,
/// by really making one and removing it. Then the disk has space and inodes, and neither a quota
/// nor a limit of this process is used up.
/// @throws std::runtime_error that names the folder and what is missing
void require_room(const std::filesystem::path& folder, std::uint64_t size);

} // namespace rigor
