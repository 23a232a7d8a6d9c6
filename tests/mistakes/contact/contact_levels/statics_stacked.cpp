// SPDX-License-Identifier: MIT
// A static body has level 0, whatever it rests on.
#include "mistakes/contact/contact_levels.hpp"

namespace rigor {

std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    ContactLevels wrong;
    wrong.rests = [](bool) { return true; };
    wrong.statics_stay = false;
    return wrong(rests_on, is_static);
}

} // namespace rigor
