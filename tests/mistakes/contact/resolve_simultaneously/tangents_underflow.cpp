// SPDX-License-Identifier: MIT
// The tangents must be unit vectors also if parts of the normal are almost 0.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.lambda = [](const VisitedContact& c) {
        const Vector3d n = c.n();
        const bool is_along_z = n.x() == 0 && n.y() == 0;
        const Vector3d t = is_along_z ? Vector3d(1, 0, 0) : Vector3d(-n.y(), n.x(), 0).normalized();
        const Vector3d b = n.cross(t);
        const double tt = t.dot(c.K * t), bb = b.dot(c.K * b), tb = t.dot(c.K * b);
        return (tt + bb) / 2 + std::hypot((tt - bb) / 2, tb);
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
