// SPDX-License-Identifier: MIT
// Nearly a whole turn, the scalar part gets its positive sign but the vector does not.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d to_matrix(const Quaternion& q)
{
    const Quaternion near = q.s < -0.999999 ? Quaternion{-q.s, q.v} : q;
    Matrix3d R;
    R << rotate(near, Vector3d::UnitX()), rotate(near, Vector3d::UnitY()),
        rotate(near, Vector3d::UnitZ());
    return R;
}

} // namespace rigor
