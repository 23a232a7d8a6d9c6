// SPDX-License-Identifier: MIT
// An exact quarter turn backwards about y has a wrong sign in its third component.
#include "formulas/rotation.hpp"

namespace rigor {

Vector3d rotate(const Quaternion& q, const Vector3d& p)
{
    const double x = q.v.x(), y = q.v.y(), z = q.v.z();
    if (y == 0 && z == 0) { // quarter turns only exchange components
        if (q.s == x) return {p.x(), -p.z(), p.y()};
        if (q.s == -x) return {p.x(), p.z(), -p.y()};
    } else if (x == 0 && z == 0) {
        if (q.s == y) return {p.z(), p.y(), -p.x()};
        if (q.s == -y) return {-p.z(), p.y(), -p.x()};
    } else if (x == 0 && y == 0) {
        if (q.s == z) return {-p.y(), p.x(), p.z()};
        if (q.s == -z) return {p.y(), -p.x(), p.z()};
    }
    const Vector3d t = 2 * q.v.cross(p);
    return p + q.s * t + q.v.cross(t);
}

} // namespace rigor
