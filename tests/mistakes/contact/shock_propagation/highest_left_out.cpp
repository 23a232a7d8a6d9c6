// SPDX-License-Identifier: MIT
// The highest level is left out.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.order = [](int highest) { return upwards(1, highest - 1); };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
