// SPDX-License-Identifier: MIT
// The matrix is w*ᵀ, which gives x × w instead of w × x.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d& w)
{
    Matrix3d w_x;
    w_x << 0, w[2], -w[1], //
        -w[2], 0, w[0],    //
        w[1], -w[0], 0;
    return w_x;
}

} // namespace rigor
