// SPDX-License-Identifier: MIT
// All bodies of lower levels are to be held, not only those of the next lower one.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.is_held = [](const Body&, int its_level, int level) { return its_level == level - 1; };
    wrong.take_over = [](Body& body, const Body& resolved, bool) {
        const Body own = body;
        body = resolved;
        body.inverse_mass = own.inverse_mass;
        body.inverse_inertia = own.inverse_inertia;
    };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
