// SPDX-License-Identifier: MIT
// What a diagnosis is made from: inputs of a formula with the right answer and the student's.
#pragma once

#include "diagnosis/layout.hpp"

#include <functional>

namespace rigor::diagnosis {

/// Asks an implementation. Nothing if it gives no answer: it crashed, or its time is used up.
using Ask = std::function<std::optional<Value>(const Value& arguments)>;

/// Answers that differ by less than this count as equal, relative to their size. It is far above
/// rounding in inputs of size 1 and far below any mistake but single precision.
constexpr double rounding = 1e-9;
/// Answers that differ by more than this are different. Between the two bounds nothing is said.
constexpr double clear = 1e-7;

enum class Agreement { same, unclear, different };

/// An input with its two answers.
struct Case {
    Value arguments, right, answer;
    bool is_drawn = true;             // at random, and then not brought to a special case
    double noise = 0;                 // differences below it say nothing, in the unit of the answer
    std::vector<Agreement> agreement; // at each place of the answer

    bool is_same_shape() const { return right.sizes == answer.sizes; }
    bool is_different() const;
    bool is_same() const;
};

struct Evidence {
    const Layout& arguments;
    const Layout& answer;
    std::vector<Case> cases;
    Ask reference;
};

/// Compares two answers at one place. Directions of either sign agree, and so do any two answers
/// where the contract leaves the choice.
Agreement compare(const Layout& layout, int role, const Value& right, const Value& answer,
                  double noise = 0);

/// Whether two answers agree everywhere, up to rounding.
bool agree(const Layout& layout, const Value& right, const Value& answer, double noise = 0);

/// A case with its agreement filled in.
Case compared(const Layout& answer, Case c);

/// Whether two lists of numbers are equal up to `bound` relative to the larger one. NaN is equal to
/// NaN here: both implementations fail in the same way.
bool close(std::span<const double> a, std::span<const double> b, double bound, double noise = 0);

/// Euclidean length.
double norm(std::span<const double> numbers);

} // namespace rigor::diagnosis
