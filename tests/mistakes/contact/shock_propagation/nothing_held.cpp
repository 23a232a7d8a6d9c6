// SPDX-License-Identifier: MIT
// The bodies below a level must be held fixed, or the weight above pushes them down again.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.is_held = [](const Body& body, int, int) { return body.is_static(); };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
