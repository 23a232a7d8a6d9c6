// SPDX-License-Identifier: MIT
// The bodies of the level being resolved must be free to move.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.is_held = [](const Body&, int its_level, int level) {
        return its_level <= level && level > 1;
    };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
