// SPDX-License-Identifier: MIT
// A static body counts as one of level 0, whatever its level in `levels` is.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    std::vector<int> changed = levels;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].is_static()) changed[i] = 0;
    return ShockPropagation()(bodies, contacts, changed, n);
}

} // namespace rigor
