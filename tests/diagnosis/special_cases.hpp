// SPDX-License-Identifier: MIT
// Special cases of drawn arguments. A mistake that shows only for a body at rest, for a static body
// or for a tiny number needs inputs that a random draw does not have.
#pragma once

#include "diagnosis/layout.hpp"

namespace rigor::diagnosis {

struct Input {
    Value arguments;
    bool is_drawn = true;
    double smallest = 1; // the factor by which numbers may have become smaller
};

/// Special cases of these arguments: numbers that are 0 or tiny, equal vectors, static bodies,
/// other units, lists of equal elements, special matrices (diagonal, of rank 1). Unit vectors and
/// rotations stay what they are.
std::vector<Input> special_cases(const Layout& arguments, const std::vector<Value>& drawn);

/// Inputs like this one: the numbers of each place grow or shrink by a factor of their own, so that
/// zeros, equal numbers and static bodies remain.
std::vector<Input> neighbours(const Layout& arguments, const Value& input, unsigned seed, int n);

} // namespace rigor::diagnosis
