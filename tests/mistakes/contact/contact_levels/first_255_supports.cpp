// SPDX-License-Identifier: MIT
// Only the first 255 supports of a body are followed; the others count with the levels that they
// happen to have by then.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

namespace {

int level_of(int i, const std::vector<std::vector<int>>& rests_on,
             const std::vector<bool>& is_static, std::vector<int>& levels)
{
    if (levels[i] >= 0) return levels[i];
    levels[i] = is_static[i] ? 0 : 1;
    if (is_static[i]) return 0;
    std::size_t followed = 0;
    int level = 1;
    for (int below : rests_on[i]) {
        const bool follows = followed++ < 255;
        level = std::max(
            level, 1 + (follows ? level_of(below, rests_on, is_static, levels) : levels[below]));
    }
    return levels[i] = level;
}

} // namespace

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    std::vector<int> levels(rests_on.size(), -1);
    for (std::size_t i = 0; i < levels.size(); ++i)
        level_of(static_cast<int>(i), rests_on, is_static, levels);
    return levels;
}

} // namespace rigor
