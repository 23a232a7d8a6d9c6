// SPDX-License-Identifier: MIT
// The sign of s is wrong: the condition is v·n ≥ s, not v·n ≥ -s.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.push = [](const VisitedContact& c) {
        const double missing = c.v.dot(c.n()) + c.contact.separation_speed;
        return std::max(0.0, c.j.dot(c.n()) - missing / c.push_stiffness());
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
