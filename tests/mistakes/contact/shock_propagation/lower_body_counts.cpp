// SPDX-License-Identifier: MIT
// A contact belongs to the level of its higher body.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.order = [](int highest) { return upwards(0, highest); };
    wrong.level_of = [](int level1, int level2) { return std::min(level1, level2); };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
