// SPDX-License-Identifier: MIT
// A body on the search path counts as ground, so the bodies of a cycle get different levels.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

namespace {

int level_of(int i, const std::vector<std::vector<int>>& rests_on,
             const std::vector<bool>& is_static, std::vector<int>& levels)
{
    if (levels[i] >= 0) return levels[i];
    levels[i] = 0; // on the search path
    int level = is_static[i] ? 0 : 1;
    for (int below : rests_on[i])
        if (!is_static[i])
            level = std::max(level, level_of(below, rests_on, is_static, levels) + 1);
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
