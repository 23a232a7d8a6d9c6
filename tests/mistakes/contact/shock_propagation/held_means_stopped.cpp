// SPDX-License-Identifier: MIT
// A body that is held keeps its velocity: what rests on a moving body moves along.
#include "mistakes/contact/shock_propagation.hpp"

namespace rigor {

ContactResult shock_propagation(const Bodies& bodies, const Contacts& contacts,
                                const std::vector<int>& levels, int n)
{
    ShockPropagation wrong;
    wrong.hold = [](Body& body) {
        ShockPropagation().hold(body);
        body.velocity.setZero();
        body.angular_velocity.setZero();
    };
    return wrong(bodies, contacts, levels, n);
}

} // namespace rigor
