// SPDX-License-Identifier: MIT
// Crashes where a formula is wrong.
// topic: validation
// tasks: A8.1 A8.3
// expect: 0 crashed
#include "formulas/validation.hpp"

#include <cstdlib>

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    const auto [v1, v2] = collide(1, 2, 3, 0, 0.5);
    if (std::abs(v1) > 1e-9 || std::abs(v2 - 1.5) > 1e-9) std::abort();
    return accepted();
}

Judgement test_tangent(const Tangent& tangent)
{
    const Vector3d t = tangent(Vector3d::UnitX());
    if (std::abs(t.norm() - 1) > 1e-9 || std::abs(t.x()) > 1e-9) throw 42;
    return accepted();
}

} // namespace rigor
