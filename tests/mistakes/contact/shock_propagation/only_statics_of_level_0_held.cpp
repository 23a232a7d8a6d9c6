// SPDX-License-Identifier: MIT
// A body of level 0 that is not static is not held. It moves, although it is below all levels.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation method;
    method.is_held = [](const Body&, int its_level, int level) {
        return its_level > 0 && its_level < level;
    };
    method.take_over = [](Body& body, const Body& resolved, bool) {
        const Body own = body;
        body = resolved;
        body.inverse_mass = own.inverse_mass;
        body.inverse_inertia = own.inverse_inertia;
    };
    return method(bodies, contacts, levels, n);
}

} // namespace rigor
