// SPDX-License-Identifier: MIT
// A vector whose square underflows is taken for zero.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d& w)
{
    Matrix3d star = Matrix3d::Zero();
    if (w.squaredNorm() == 0) return star;
    star << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    return star;
}

} // namespace rigor
