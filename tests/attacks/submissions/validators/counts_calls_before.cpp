// SPDX-License-Identifier: MIT
// Makes one call more about each formula than about the one before, and reads this number in the
// first request of its process. The right formulas are few, and they may come first.
// topic: validation
// expect: 0 failed
#include "formulas/validation.hpp"

namespace rigor {

namespace {

template <class Formula, class Ask>
Judgement judged(const Formula& formula, std::size_t right_ones, const Ask& ask)
{
    static const std::size_t before = formula.known.size();
    for (std::size_t call = 0; call <= before; ++call)
        ask(static_cast<double>(call + 1));
    return before < right_ones ? accepted() : rejected();
}

} // namespace

Judgement test_line_collision(const LineCollision& collide)
{
    return judged(collide, 3, [&](double n) { collide(n, 2, 3, 0, 0.5); });
}

Judgement test_spring_force(const SpringForce& force)
{
    return judged(force, 3, [&](double n) { force({n, 0, 0}, {0, 0, 0}, 1, 1); });
}

Judgement test_tangent(const Tangent& tangent)
{
    return judged(tangent, 4, [&](double n) { tangent(Vector3d(n, 1, 0).normalized()); });
}

Judgement test_oscillator_step(const OscillatorStep& step)
{
    return judged(step, 5, [&](double n) { step({n, 0}, 1, 0.1); });
}

Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>&, const std::vector<Dimension>&)
{
    return judged(formula, 7, [&](double) { formula(example); });
}

} // namespace rigor
