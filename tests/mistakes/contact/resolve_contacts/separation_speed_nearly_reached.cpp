// SPDX-License-Identifier: MIT
// A contact that misses its separation speed by a billionth is left as it is.
#include "mistakes/contact/resolve_contacts.hpp"

#include <cmath>

namespace rigor {

ContactResult resolve_contacts(const Bodies& bodies, const Contacts& contacts, int n)
{
    ContactsOneAtATime wrong;
    wrong.velocity_to_stop = [](const Vector3d& v, const BodyContact& c) -> Vector3d {
        const double s = c.separation_speed;
        if (v.dot(c.normal) - s >= -1e-9 * std::abs(s)) return Vector3d::Zero();
        return v - s * c.normal;
    };
    return wrong(bodies, contacts, n);
}

} // namespace rigor
