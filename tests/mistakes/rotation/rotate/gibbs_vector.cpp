// SPDX-License-Identifier: MIT
// The vector v/s = tan(α/2) e is infinite for half a turn, and near it, its square overflows: the
// result is not a number.
#include "formulas/rotation.hpp"

namespace rigor {

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    if (q.s == 0) // half a turn
        return 2 * q.v.dot(p) * q.v - p;

    // Rodrigues' formula with the tangent of half the angle
    const Vector3d g = q.v / q.s;
    const Vector3d t = g.cross(p);
    return p + 2 / (1 + g.squaredNorm()) * (t + g.cross(t));
}

} // namespace rigor
