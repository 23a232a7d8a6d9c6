// SPDX-License-Identifier: MIT
// How the screen is shared between the scene and letters.
#pragma once

#include <algorithm>

namespace rigor {

/// Heights of letters [pixels]. @param height  of the picture
inline int small_letters(int height)
{
    return std::clamp(height / 42, 10, 48);
}
inline int large_letters(int height)
{
    return std::clamp(height / 32, 12, 64);
}

/// Width of the strip at the right border that belongs to the bar of colors, where there is one:
/// the scene is drawn to the left of it [pixels].
inline int color_bar_strip(int width, int height)
{
    return std::min(36 * small_letters(height) / 5, width / 2);
}

} // namespace rigor
