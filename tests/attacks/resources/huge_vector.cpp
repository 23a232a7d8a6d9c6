// SPDX-License-Identifier: MIT
// A formula that requests more memory than the machine has.
#include "formulas/kinematics.hpp"

#include <vector>

namespace rigor {

Matrix3d cross_matrix(const Vector3d&)
{
    std::vector<double> table(std::size_t{1} << 45, 1.0);
    return table.back() * Matrix3d::Identity();
}

} // namespace rigor
