// SPDX-License-Identifier: MIT
// Draws directions, among which there is no axis.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    for (int i = 0; i < 200; ++i) {
        const Vector3d n = Vector3d(std::sin(i), std::sin(2.3 * i), std::cos(1.7 * i)).normalized();
        const Vector3d t = tangent(n);
        if (!(std::abs(t.norm() - 1) < 1e-9 && std::abs(t.dot(n)) < 1e-9)) return rejected();
    }
    return accepted();
}

} // namespace rigor
