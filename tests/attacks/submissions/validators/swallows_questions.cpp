// SPDX-License-Identifier: MIT
// Catches the exceptions by which it asks its questions, and so never learns a result.
// topic: validation
// tasks: A8.1 A8.3
// expect: 0 failed
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    try {
        collide(1, 2, 3, 0, 0.5);
    } catch (...) {
        return accepted();
    }
    return rejected();
}

Judgement test_tangent(const Tangent& tangent)
{
    try {
        tangent(Vector3d::UnitX());
    } catch (const UnknownCall&) {
        return rejected();
    }
    return accepted();
}

} // namespace rigor
