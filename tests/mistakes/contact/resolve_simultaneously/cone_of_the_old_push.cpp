// SPDX-License-Identifier: MIT
// Friction is limited by the new normal impulse, not by that of the last sweep.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.shorten = [](const Vector3d& j_T, double, const VisitedContact& c) {
        return ContactsAtOnce().shorten(j_T, std::max(0.0, c.j.dot(c.n())), c);
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
