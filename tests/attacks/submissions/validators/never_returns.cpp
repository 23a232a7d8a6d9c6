// SPDX-License-Identifier: MIT
// Does not return where a formula is wrong, in the hope that this counts as a rejection.
// topic: validation
// tasks: A8.3
// expect: 0 timed_out
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_tangent(const Tangent& tangent)
{
    const Vector3d t = tangent(Vector3d::UnitX());
    if (std::abs(t.norm() - 1) < 1e-12 && std::abs(t.x()) < 1e-12) return accepted();
    for (volatile int i = 0;; i = i + 1) {
    }
}

} // namespace rigor
