// SPDX-License-Identifier: MIT
// A static body counts as being at rest if it is the first of a contact, although a belt moves.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    Bodies at_rest = bodies;
    for (const BodyContact& contact : contacts)
        if (Body& first = at_rest[contact.body1]; first.is_static()) {
            first.velocity.setZero();
            first.angular_velocity.setZero();
        }
    ContactResult result = ContactsOneAtATime()(at_rest, contacts, n);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].is_static()) result.bodies[i] = bodies[i];
    return result;
}

} // namespace rigor
