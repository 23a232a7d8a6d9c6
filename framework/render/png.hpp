// SPDX-License-Identifier: MIT
// Images as PNG files with one byte each for red, green and blue. Opacity is left out.
#pragma once

#include "render/image.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace rigor {

std::vector<std::uint8_t> png_bytes(const Image& image);

/// Writes a file completely or not at all: under a temporary name in the same folder, renamed when
/// it is complete. The function does not wait until the disk has the bytes: frames that are lost in
/// a power failure can be drawn again.
/// @throws InputError that names the file and the reason, such as a full disk
void write_picture(const std::filesystem::path& file, std::span<const std::uint8_t> bytes);

} // namespace rigor
