// SPDX-License-Identifier: MIT
// Writes other results and arguments into the list of calls, which is its own copy.
// topic: validation
// tasks: A8.1 A8.3
// expect: 0 failed|crashed
#include "formulas/validation.hpp"

namespace rigor {

Judgement test_line_collision(const LineCollision& collide)
{
    auto& calls = const_cast<LineCollision&>(collide).known;
    calls.assign(100, {{1, 2, 3, 0, 0.5}, {0, 1.5}});
    const auto [v1, v2] = collide(1, 2, 3, 0, 0.5);
    return v1 == 0 && v2 == 1.5 ? accepted() : rejected();
}

Judgement test_tangent(const Tangent& tangent)
{
    auto& calls = const_cast<Tangent&>(tangent).known;
    for (KnownCall& call : calls)
        call.result.assign(1 << 20, 0);
    calls.resize(calls.size() + 1);
    return tangent(Vector3d::UnitX()).x() == 0 ? accepted() : rejected();
}

} // namespace rigor
