// SPDX-License-Identifier: MIT
// Bodies that were held fixed must get their own mass and inertia back.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.take_over = [](Body& body, const Body& resolved, bool) { body = resolved; };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
