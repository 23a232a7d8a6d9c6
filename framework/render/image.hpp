// SPDX-License-Identifier: MIT
// An image as an array of pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rigor {

/// Each pixel has one byte each for red, green, blue (in sRGB) and opacity. The first row is the
/// top row.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;

    const std::uint8_t* pixel(int x, int y) const
    {
        return rgba.data() + 4 * (static_cast<std::size_t>(y) * width + x);
    }
};

} // namespace rigor
