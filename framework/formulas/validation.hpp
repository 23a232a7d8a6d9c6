// SPDX-License-Identifier: MIT
// Topic `validation`, assignment A8: tests that tell right formulas from wrong ones.
// Each task describes a formula and asks for a test of it. The test gets an implementation of the
// formula, calls it up to 1000 times, and says whether the implementation keeps the laws.
// Conventions: types.hpp; what a test may do: under_test.hpp.
//
// A right implementation follows the description of its formula up to rounding: its results may
// differ from those of another right implementation by 1e-12 times the largest term. It may be
// written in any way. A test may call it with arguments whose magnitudes are 1e-9 to 1e9, or 0
// where the description allows that. A wrong implementation may be wrong anywhere in these ranges.
#pragma once

#include "formulas/dimension.hpp"
#include "formulas/not_implemented.hpp"
#include "formulas/types.hpp"
#include "formulas/under_test.hpp"

namespace rigor {

/// The velocities of two bodies on a line [m/s]. In the result of a `LineCollision`, the fields v1
/// and v2 are the velocities after the collision, u₁ and u₂.
struct LineVelocities {
    double v1 = 0, v2 = 0;
};

/// The formula (m₁, m₂, v₁, v₂, ε) → the velocities u₁, u₂ after a collision on a line. Body 1
/// touches body 2 from the left; the positive direction is to the right.
///
///     v₁ ≤ v₂, they do not approach: u₁ = v₁ and u₂ = v₂
///     otherwise  u₁ - u₂ = -ε (v₁ - v₂)   and   m₁ u₁ + m₂ u₂ = m₁ v₁ + m₂ v₂
///
/// with the masses m₁, m₂ > 0 [kg] and the restitution 0 ≤ ε ≤ 1. The largest term is the larger
/// one of |v₁| and |v₂|, also where the bodies do not approach: u₁ and u₂ may be rounded there too.
using LineCollision = UnderTest<LineVelocities, double, double, double, double, double>;

/// The formula (x₁, x₂, k, L) → the force of a spring on its end x₁ [N].
///
///     f = k (|x₂ - x₁| - L) (x₂ - x₁) / |x₂ - x₁|        x₁ = x₂: 0, the force has no direction
///
/// with the ends x₁, x₂ [m], the stiffness k ≥ 0 [N/m] and the rest length L ≥ 0 [m]. A spring that
/// is shorter than L pushes. The largest term is k (|x₂ - x₁| + L), however far both ends are from
/// the origin.
using SpringForce = UnderTest<Vector3d, Vector3d, Vector3d, double, double>;

/// The formula n → a unit vector t perpendicular to the unit vector n. Any such t is right.
using Tangent = UnderTest<Vector3d, Vector3d>;

/// Position and velocity of an oscillator.
struct OscillatorState {
    double x = 0; // [m]
    double v = 0; // [m/s]
};

/// The formula (state, ω, h) → the state of the oscillator ẍ = -ω² x after a time step h, by a
/// method of second order or higher.
///
/// ω > 0 [rad/s], h > 0 [s], and ω h ≤ ½. The method is left open. With the amplitude
/// A = √(x² + v²/ω²), the error of one step is at most (ω h)³ A in the position, and at most
/// ω (ω h)³ A in the velocity. A formula that exceeds one of these bounds is wrong, whatever its
/// order. An oscillator that rests at x = 0 stays there.
using OscillatorStep = UnderTest<OscillatorState, OscillatorState, double, double>;

/// A formula that takes a list of numbers and returns a list of numbers. Only the dimensions of
/// these numbers are known.
using UnknownFormula = UnderTest<std::vector<double>, std::vector<double>>;

/// A8.1 A test of a collision on a line.
Judgement test_line_collision(const LineCollision& collide);

/// A8.2 A test of the force of a spring.
Judgement test_spring_force(const SpringForce& force);

/// A8.3 A test of a tangent.
Judgement test_tangent(const Tangent& tangent);

/// A8.4 A test of a time step of an oscillator.
Judgement test_oscillator_step(const OscillatorStep& step);

/// A8.5 The law of the units, for any formula: if the unit of mass, length or time is replaced by
/// another one, each number of the result changes as its dimension says. The formula is accepted
/// if this holds for each of the three units, smaller and larger by factors up to 2⁴⁰.
///
/// A right formula may take a root of a factor, which need not be exact: √(2⁴) = 2², but √2 is
/// rounded. So the test must allow for rounding, by 1e-12 times the number of the result itself.
/// What is 0 for the example stays exactly 0, since no right formula subtracts roots.
///
/// @param formula    takes as many numbers as `arguments` has dimensions
/// @param example    arguments that the formula is made for, also after a unit is changed by a
///                   factor from 2⁻⁴⁰ to 2⁴⁰
/// @param arguments  the dimension of each argument
/// @param result     the dimension of each number of the result
Judgement test_units(const UnknownFormula& formula, const std::vector<double>& example,
                     const std::vector<Dimension>& arguments, const std::vector<Dimension>& result);

RIGOR_FIELDS(Dimension, mass, length, time)
RIGOR_FIELDS(LineVelocities, v1, v2)
RIGOR_FIELDS(OscillatorState, x, v)

} // namespace rigor
