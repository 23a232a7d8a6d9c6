// SPDX-License-Identifier: MIT
// The levels are resolved from the ground up, so that each level finds its supports at rest.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.order = [](int highest) {
        std::vector<int> order = upwards(1, highest);
        std::reverse(order.begin(), order.end());
        return order;
    };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
