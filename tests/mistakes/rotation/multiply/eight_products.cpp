// SPDX-License-Identifier: MIT
// Eight products instead of sixteen lose small components beside large ones.
#include "formulas/rotation.hpp"

namespace rigor {

Quaternion multiply(const Quaternion& a, const Quaternion& b)
{
    const Vector3d &u = a.v, &v = b.v;
    const double A = (a.s + u.x()) * (b.s + v.x()), B = (u.z() - u.y()) * (v.y() - v.z());
    const double C = (a.s - u.x()) * (v.y() + v.z()), D = (u.y() + u.z()) * (b.s - v.x());
    const double E = (u.x() + u.z()) * (v.x() + v.y()), F = (u.x() - u.z()) * (v.x() - v.y());
    const double G = (a.s + u.y()) * (b.s - v.z()), H = (a.s - u.y()) * (b.s + v.z());
    return {B + (-E - F + G + H) / 2,
            {A - (E + F + G + H) / 2, C + (E - F + G - H) / 2, D + (E - F - G + H) / 2}};
}

} // namespace rigor
