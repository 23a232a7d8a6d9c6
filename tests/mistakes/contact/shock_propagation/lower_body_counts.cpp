// SPDX-License-Identifier: MIT
// The level of a contact is the higher level of its two bodies, not the lower one.
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
