// SPDX-License-Identifier: MIT
// The sign of s is wrong: u = v - s n, so that a positive s makes the bodies separate.
#include "mistakes/contact/resolve_contacts.hpp"

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.velocity_to_stop = [](const Vector3d& v, const BodyContact& c) -> Vector3d {
        return v + c.separation_speed * c.normal;
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
