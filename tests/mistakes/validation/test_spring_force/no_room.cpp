// SPDX-License-Identifier: MIT
// Allows for less rounding than a sum of the same terms has.
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_spring_force(const SpringForce& force)
{
    for (int i = 1; i < 60; ++i) {
        const Vector3d x1(0.3 * i, -i, 1), x2(i % 7, 0.1, i % 5);
        const Vector3d d = x2 - x1, f = 3 * (d.norm() - 0.1 * i) / d.norm() * d;
        if (!((force(x1, x2, 3, 0.1 * i) - f).norm() <= 1e-17)) return rejected();
    }
    return accepted();
}

} // namespace rigor
