// SPDX-License-Identifier: MIT
// An image as an array of pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor {

/// Red, green, blue, opacity, one byte each in sRGB; rows from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    const std::uint8_t* pixel(int x, int y) const
    {
        return rgba.data() + 4 * (static_cast<std::size_t>(y) * width + x);
    }
};

} // namespace rigor
