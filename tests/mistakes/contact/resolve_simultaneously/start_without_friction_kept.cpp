// SPDX-License-Identifier: MIT
// Without friction, a sweep has to remove the tangential part of the start; here it is kept.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.shorten = [](const Vector3d& j_T, double j_n, const VisitedContact& c) -> Vector3d {
        if (c.contact.friction == 0) return c.j - c.j.dot(c.n()) * c.n(); // nothing to change
        const double most = c.contact.friction * j_n;
        return j_T.norm() > most ? Vector3d(j_T * (most / j_T.norm())) : j_T;
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
