// SPDX-License-Identifier: MIT
// The correct part of A4.8 that most of its mistakes share.
#pragma once

#include "formulas/collision.hpp"

#include <algorithm>

namespace rigor {

/// The impulse of a contact that jams, nᵀ K (n - μ T) ≤ 0: the sticking impulse, with its
/// tangential part shortened to the limit of friction.
inline Vector3d jammed_impulse(const Matrix3d& K, const Vector3d& v, const Vector3d& n,
                               double restitution, double friction)
{
    const Vector3d j = static_friction_impulse(K, v, n, restitution);
    const double j_n = j.dot(n);
    const Vector3d j_T = j - j_n * n;
    if (j_n <= 0) return Vector3d::Zero();
    return j_n * n + std::min(1.0, friction * j_n / j_T.norm()) * j_T;
}

} // namespace rigor
