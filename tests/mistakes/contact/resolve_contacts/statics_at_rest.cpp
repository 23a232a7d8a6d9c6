// SPDX-License-Identifier: MIT
// Static bodies count as being at rest, although a conveyor belt moves.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    Bodies at_rest = bodies;
    for (Body& body : at_rest)
        if (body.is_static()) {
            body.velocity.setZero();
            body.angular_velocity.setZero();
        }
    ContactResult result = ContactsOneAtATime()(at_rest, contacts, n);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].is_static()) result.bodies[i] = bodies[i];
    return result;
}

} // namespace rigor
