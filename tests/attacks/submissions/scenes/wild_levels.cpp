// SPDX-License-Identifier: MIT
// Returns a level for each body, as it must, but levels that count as many bodies as an integer
// can. Loops over levels would not end, and lists of them would not fit in memory.
// topic: contact
// tasks: A5.3
// beside: contact_levels
// expect: 0 failed: contact_levels returned the level
#include "formulas/contact.hpp"

#include <climits>

namespace rigor {

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>&)
{
    std::vector<int> levels(rests_on.size(), INT_MAX);
    for (std::size_t i = 0; i < levels.size(); i += 2)
        levels[i] = INT_MIN;
    return levels;
}

} // namespace rigor
