// SPDX-License-Identifier: MIT
// A formula that throws an exception of the standard library.
#include "formulas/kinematics.hpp"

#include <stdexcept>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    throw std::out_of_range("vector::at");
}

} // namespace rigor
