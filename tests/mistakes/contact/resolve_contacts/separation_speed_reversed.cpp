// SPDX-License-Identifier: MIT
// u = v - s n: a positive s asks for separation.
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
