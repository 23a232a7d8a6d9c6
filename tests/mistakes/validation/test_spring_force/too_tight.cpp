// SPDX-License-Identifier: MIT
// Allows for less rounding than a right formula may have, and for none at the rest length.
#include "formulas/validation.hpp"

#include <cmath>
#include <random>

namespace rigor {

Judgement test_spring_force(const SpringForce& force)
{
    std::mt19937 bits(5);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const auto vector = [&] {
        const double x = uniform(bits), y = uniform(bits);
        return Vector3d(x, y, uniform(bits));
    };
    for (int i = 0; i < 300; ++i) {
        const double size = std::pow(10, 6 * uniform(bits)), k = std::pow(10, 6 * uniform(bits));
        const Vector3d x1 = size * vector(), x2 = size * vector(), d = x2 - x1;
        const double r = d.norm(), L = r * std::pow(10, 2 * uniform(bits));
        const Vector3d expected = k * (r - L) * d / r;
        if (!((force(x1, x2, k, L) - expected).norm() <= 1e-14 * k * (r + L))) return rejected();
    }
    const Vector3d x = {0.5, -1, 2};
    if (force(x, x, 3, 1) != Vector3d::Zero()) return rejected();
    if (force(x, x + Vector3d::UnitX(), 3, 1) != Vector3d::Zero()) return rejected();
    return accepted();
}

} // namespace rigor
