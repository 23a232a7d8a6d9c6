// SPDX-License-Identifier: MIT
// The total impulse must push, but its change may pull, to reduce an impulse that was too large.
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
