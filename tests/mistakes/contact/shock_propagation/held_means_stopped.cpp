// SPDX-License-Identifier: MIT
// A body that is held fixed keeps its velocity, so that bodies on a moving one move with it.
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
