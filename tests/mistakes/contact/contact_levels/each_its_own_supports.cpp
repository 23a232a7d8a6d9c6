// SPDX-License-Identifier: MIT
// The bodies of a cycle share one level, above all other bodies that any of them rests on.
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
