// SPDX-License-Identifier: MIT
// The level is one above the highest support, not one above the lowest.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

namespace {

int level_of(int i, const std::vector<std::vector<int>>& rests_on,
             const std::vector<bool>& is_static, std::vector<int>& levels)
{
    if (levels[i] != 0 || is_static[i]) return levels[i];
    levels[i] = 1; // a cycle ends here
    int lowest = 0;
    for (std::size_t k = 0; k < rests_on[i].size(); ++k) {
        const int below = level_of(rests_on[i][k], rests_on, is_static, levels);
        lowest = k == 0 ? below : std::min(lowest, below);
    }
    return levels[i] = lowest + 1;
}

} // namespace

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    std::vector<int> levels(rests_on.size(), 0);
    for (std::size_t i = 0; i < levels.size(); ++i)
        level_of(static_cast<int>(i), rests_on, is_static, levels);
    return levels;
}

} // namespace rigor
