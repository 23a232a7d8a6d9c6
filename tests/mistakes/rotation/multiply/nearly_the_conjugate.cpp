// SPDX-License-Identifier: MIT
// A factor that is the conjugate of the other one up to 1e-12 is taken for it, so their product has
// no vector part.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    if ((a.v + b.v).norm() <= 1e-12 * a.v.norm() && a.s == b.s)
        return {a.s * a.s + a.v.squaredNorm(), Vector3d::Zero()};
    return {a.s * b.s - a.v.dot(b.v), a.s * b.v + b.s * a.v + a.v.cross(b.v)};
}

} // namespace rigor
