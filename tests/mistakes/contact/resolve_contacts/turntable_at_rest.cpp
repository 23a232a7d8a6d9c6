// SPDX-License-Identifier: MIT
// A static body may move, but its spin is ignored.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    Bodies not_turning = bodies;
    for (Body& body : not_turning)
        if (body.is_static()) body.angular_velocity.setZero();
    ContactResult result = ContactsOneAtATime()(not_turning, contacts, n);
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (bodies[i].is_static()) result.bodies[i] = bodies[i];
    return result;
}

} // namespace rigor
