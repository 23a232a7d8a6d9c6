// SPDX-License-Identifier: MIT
// A formula that throws an int, which is not derived from std::exception.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    throw 42;
}

} // namespace rigor
