// SPDX-License-Identifier: MIT
// Levels above 1000 are taken as 1000.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    std::vector<int> limited = levels;
    for (int& level : limited)
        level = std::min(level, 1000);
    return ShockPropagation()(bodies, contacts, limited, n);
}

} // namespace rigor
