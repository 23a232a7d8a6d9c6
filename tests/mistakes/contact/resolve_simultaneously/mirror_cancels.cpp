// SPDX-License-Identifier: MIT
// The tangents come from the mirror that exchanges z and the normal. Where the two are nearly
// equal, their difference has lost its digits.
#include "mistakes/contact/resolve_simultaneously.hpp"

namespace rigor {

ContactResult resolve_simultaneously(const Bodies& bodies, const Contacts& contacts, int sweeps)
{
    ContactsAtOnce wrong;
    wrong.lambda = [](const VisitedContact& c) {
        const Vector3d u = c.n() - Vector3d::UnitZ();
        const double squared = u.squaredNorm();
        const Matrix3d mirror =
            Matrix3d::Identity() - (squared > 0 ? 2 / squared : 0) * u * u.transpose();
        const Vector3d t = mirror.col(0), b = mirror.col(1);
        const double tt = t.dot(c.K * t), bb = b.dot(c.K * b), tb = t.dot(c.K * b);
        return (tt + bb) / 2 + std::hypot((tt - bb) / 2, tb);
    };
    return wrong(bodies, contacts, sweeps);
}

} // namespace rigor
