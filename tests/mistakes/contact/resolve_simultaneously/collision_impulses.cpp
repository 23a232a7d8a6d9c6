// SPDX-License-Identifier: MIT
// `collision_impulse` only adds to the impulse of a contact, which must also be able to decrease.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.impulse = [](const VisitedContact& c) -> Vector3d {
        const Vector3d u = c.v - c.contact.separation_speed * c.n();
        return c.j + collision_impulse(c.K, u, c.n(), 0, c.contact.friction);
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
