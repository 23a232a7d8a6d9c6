// SPDX-License-Identifier: MIT
// If a factor differs from the conjugate of the other one by less than 1e-12, it counts as this
// conjugate, and the product has no vector part.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    if ((a.v + b.v).norm() <= 1e-12 * a.v.norm() && a.s == b.s)
        return {a.s * a.s + a.v.squaredNorm(), Vector3d::Zero()};
    return {a.s * b.s - a.v.dot(b.v), a.s * b.v + b.s * a.v + a.v.cross(b.v)};
}

} // namespace rigor
