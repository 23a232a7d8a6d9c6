// SPDX-License-Identifier: MIT
// Throws what is no exception.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    throw 42;
}

} // namespace rigor
