// SPDX-License-Identifier: MIT
// What a static body rests on must be ignored: no cycle passes through a static body.
#include "mistakes/contact/contact_levels.hpp"

namespace rigor {

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    ContactLevels wrong;
    wrong.rests = [](bool) { return true; };
    return wrong(rests_on, is_static);
}

} // namespace rigor
