// SPDX-License-Identifier: MIT
// Assignment A8. Read: assignments/a8-validation/README.md, then framework/formulas/validation.hpp.
// Check: ./rigor check validation
#include "formulas/validation.hpp"

namespace rigor {

// A8.1  momentum, restitution, and bodies that do not approach
Judgement test_line_collision(const LineCollision& collide)
{
    throw NotImplemented("validation::test_line_collision");
}

// A8.2  f = k (|x₂ - x₁| - L) (x₂ - x₁) / |x₂ - x₁|
Judgement test_spring_force(const SpringForce& force)
{
    throw NotImplemented("validation::test_spring_force");
}

// A8.3  |t| = 1, t·n = 0
Judgement test_tangent(const Tangent& tangent)
{
    throw NotImplemented("validation::test_tangent");
}

// A8.4  one step is off by at most (ω h)³ A
Judgement test_oscillator_step(const OscillatorStep& step)
{
    throw NotImplemented("validation::test_oscillator_step");
}

// A8.5  the law of the units
Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result)
{
    throw NotImplemented("validation::test_units");
}

} // namespace rigor
