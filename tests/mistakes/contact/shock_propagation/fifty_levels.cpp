// SPDX-License-Identifier: MIT
// Levels above 50 are not resolved, but a tower has as many levels as it has bodies.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.order = [](int highest) { return upwards(1, std::min(highest, 50)); };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
