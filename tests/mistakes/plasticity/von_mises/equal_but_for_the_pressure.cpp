// SPDX-License-Identifier: MIT
// Normal stresses that differ by less than a trillionth of the pressure are taken for equal.
#include "formulas/plasticity.hpp"

#include <cmath>

namespace rigor {

double von_mises(const Matrix3d& stress)
{
    const double xx = stress(0, 0), yy = stress(1, 1), zz = stress(2, 2);
    const double rounding = 1e-12 * std::abs(xx + yy + zz) / 3;
    const auto difference = [&](double a, double b) {
        return std::abs(a - b) <= rounding ? 0.0 : a - b;
    };
    const Vector3d normal(difference(xx, yy), difference(yy, zz), difference(zz, xx));
    const Vector3d shear(stress(0, 1), stress(1, 2), stress(2, 0));
    return std::sqrt(normal.squaredNorm() / 2 + 3 * shear.squaredNorm());
}

} // namespace rigor
