// SPDX-License-Identifier: MIT
// A formula that never returns.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    for (volatile unsigned i = 0;; i = i + 1) {
    }
}

} // namespace rigor
