// SPDX-License-Identifier: MIT
// Limiting two tangential directions separately gives a pyramid, not the friction cone.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.shorten = [](const Vector3d& j_T, double j_n, const VisitedContact& c) -> Vector3d {
        const Vector3d t = c.n().unitOrthogonal(), b = c.n().cross(t);
        const double most = c.contact.friction * j_n;
        return std::clamp(t.dot(j_T), -most, most) * t + std::clamp(b.dot(j_T), -most, most) * b;
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
