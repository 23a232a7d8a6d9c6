// SPDX-License-Identifier: MIT
// The whole impulse must push; what it changes by may pull, to take back a push that was too hard.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.push = [](const VisitedContact& c) {
        const double missing = c.v.dot(c.n()) - c.contact.separation_speed;
        return c.j.dot(c.n()) + std::max(0.0, -missing / c.push_stiffness());
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
