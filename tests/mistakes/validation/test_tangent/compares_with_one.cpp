// SPDX-License-Identifier: MIT
// Compares with one of the many vectors that are right.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    for (int i = 0; i < 40; ++i) {
        const Vector3d n = Vector3d(i - 20, 3, 0.2 * i).normalized();
        const Vector3d t = n.cross(Vector3d::UnitX()).normalized();
        if (!((tangent(n) - t).norm() < 1e-9)) return rejected();
    }
    return accepted();
}

} // namespace rigor
