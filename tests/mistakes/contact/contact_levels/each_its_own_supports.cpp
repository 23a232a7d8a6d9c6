// SPDX-License-Identifier: MIT
// The level of a cycle is above what any of it rests on, not each member above its own.
#include "mistakes/contact/contact_levels.hpp"

namespace rigor {

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    ContactLevels wrong;
    wrong.cycles_share = false;
    return wrong(rests_on, is_static);
}

} // namespace rigor
