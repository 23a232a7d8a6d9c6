// SPDX-License-Identifier: MIT
// The longest path is searched n times; in a cycle it grows in every round, and so do the levels.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    std::vector<int> levels;
    for (const bool fixed : is_static)
        levels.push_back(fixed ? 0 : 1);
    const int rounds = std::min(static_cast<int>(levels.size()), 100);
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < levels.size(); ++i)
            for (int below : rests_on[i])
                if (!is_static[i]) levels[i] = std::max(levels[i], levels[below] + 1);
    return levels;
}

} // namespace rigor
