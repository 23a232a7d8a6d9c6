// SPDX-License-Identifier: MIT
// Tries no spring that is shorter than its rest length.
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_spring_force(const SpringForce& force)
{
    for (int i = 1; i < 60; ++i) {
        const Vector3d x1(0.3 * i, -i, 1), d(i % 7 - 3, 1, i % 5), x2 = x1 + d;
        const double r = d.norm(), L = r * i / 60, k = 2.0 * i;
        const Vector3d f = k * (r - L) / r * d;
        if (!((force(x1, x2, k, L) - f).norm() <= 1e-12 * k * r)) return rejected();
    }
    return accepted();
}

} // namespace rigor
