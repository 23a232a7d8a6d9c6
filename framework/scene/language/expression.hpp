// SPDX-License-Identifier: MIT
// Formulas of one variable, the time t, in the text of a scene.
#pragma once

#include "scene/language/json.hpp"

#include <vector>

namespace rigor {

/// An expression of t, as a program for a machine with a stack: each instruction takes its
/// arguments from the top of the stack and puts its result there.
class Expression {
public:
    /// An instruction takes up to two arguments; its function ignores those that it does not take.
    struct Instruction {
        int arguments = 0;
        // The function that computes the result. If it is null, the result is `number` or t.
        double (*function)(double a, double b) = nullptr;
        double number = 0;
        bool is_time = false;
    };

    explicit Expression(std::vector<Instruction> program) : program_(std::move(program)) {}

    /// The value at a time [s]. It is infinite or NaN where the expression has no value.
    double operator()(double t) const;

private:
    std::vector<Instruction> program_;
};

/// Reads an expression of t. It has numbers, `t`, `pi`, + - * / ^, parentheses, and the functions
/// sin, cos, tan, exp, log, sqrt, abs, step (0 if its argument is negative, otherwise 1), min and
/// max. A power has the highest precedence and is evaluated from the right. A sign before a power
/// applies to the whole power: -t^2 is -(t^2).
///
/// @throws Mistake  which names the character at which a syntax error was found
Expression expression(const Value& value);

} // namespace rigor
