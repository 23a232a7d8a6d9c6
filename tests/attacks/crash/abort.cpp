// SPDX-License-Identifier: MIT
// A formula that calls abort.
#include "formulas/kinematics.hpp"

#include <cstdlib>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    std::abort();
}

} // namespace rigor
