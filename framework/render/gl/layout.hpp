// SPDX-License-Identifier: MIT
// The layout of the screen: the heights of letters and the strip of the color bar.
#pragma once

#include <algorithm>

namespace rigor {

/// Heights of letters [pixels]. @param height  the height of the picture [pixels]
inline int small_letters(int height)
{
    return std::clamp(height / 42, 10, 48);
}
inline int large_letters(int height)
{
    return std::clamp(height / 32, 12, 64);
}

/// Width of the strip at the right border for the color bar, if there is one [pixels]. The scene is
/// drawn to the left of it.
inline int color_bar_strip(int width, int height)
{
    return std::min(36 * small_letters(height) / 5, width / 2);
}

} // namespace rigor
