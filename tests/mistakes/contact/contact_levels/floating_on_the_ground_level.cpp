// SPDX-License-Identifier: MIT
// A body that rests on nothing has level 1; level 0 is for static bodies.
#include "mistakes/contact/contact_levels.hpp"

namespace rigor {

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    ContactLevels wrong;
    wrong.least = [](bool) { return 0; };
    return wrong(rests_on, is_static);
}

} // namespace rigor
