// SPDX-License-Identifier: MIT
// Contacts of level 0 must be left alone.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.order = [](int highest) { return upwards(0, highest); };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
