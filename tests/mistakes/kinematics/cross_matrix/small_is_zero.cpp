// SPDX-License-Identifier: MIT
// A threshold with a unit: a small vector has a matrix too.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d& w)
{
    if (w.norm() < 1e-12) return Matrix3d::Zero();
    Matrix3d star;
    star << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
    return star;
}

} // namespace rigor
