// SPDX-License-Identifier: MIT
// A formula that calls itself until the stack overflows.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d& w)
{
    const Matrix3d deeper = cross_matrix(w * 1.0000001); // used below, so that it is no tail call
    return deeper + w * w.transpose();
}

} // namespace rigor
