// SPDX-License-Identifier: MIT
// Compares how strong the force is, and not where it points.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_spring_force(const SpringForce& force)
{
    for (int i = 0; i < 40; ++i) {
        const Vector3d x1(i, 0.5, -2), x2(3, 0.1 * i, 1);
        const double r = (x2 - x1).norm(), L = 0.3 * i;
        const double strength = force(x1, x2, 7, L).norm();
        if (!(std::abs(strength - 7 * std::abs(r - L)) < 1e-9 * (r + L))) return rejected();
    }
    return force(Vector3d::Zero(), Vector3d::Zero(), 7, 1).norm() == 0 ? accepted() : rejected();
}

} // namespace rigor
