// SPDX-License-Identifier: MIT
// A formula that is not implemented.
#include "formulas/kinematics.hpp"

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    throw NotImplemented("kinematics::cross_matrix");
}

} // namespace rigor
