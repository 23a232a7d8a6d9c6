// SPDX-License-Identifier: MIT
// A small determinant relative to the size of K counts as two static bodies.
#include "formulas/collision.hpp"

#include <cmath>

namespace rigor {

Vector3d static_friction_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                                 double restitution)
{
    if (std::abs(K.determinant()) <= 1e-9 * std::pow(K.norm(), 3)) return Vector3d::Zero();
    return K.inverse() * (-v - restitution * v.dot(n) * n);
}

} // namespace rigor
