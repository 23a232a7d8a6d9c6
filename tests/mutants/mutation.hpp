// SPDX-License-Identifier: MIT
// Small changes of a function, each of which makes a solution that may be wrong.
#pragma once

#include "mutants/source.hpp"

#include <string>
#include <vector>

namespace rigor::mutants {

/// A change of the text from offset `begin` to offset `end`.
struct Mutation {
    std::size_t begin, end;
    std::string replacement;
};

using Mutations = std::vector<Mutation>;

/// The tokens that are mutated: from `first` up to but not including `last`.
struct Range {
    std::size_t first, last;
};

/// Other operators: - for +, / for *, <= and > for <, || for &&; without a sign or a negation.
Mutations changed_operators(const Source& source, Range range);

/// Sums without one of their terms, products without a factor, conditions without a part.
Mutations dropped_operands(const Source& source, Range range);

/// Other numbers: n + 1 and n - 1 for n, thresholds that are much larger or zero, and absolute
/// thresholds where something is compared with zero.
Mutations changed_numbers(const Source& source, Range range);

/// Other functions and components: `norm` for `squaredNorm`, `cos` for `sin`, y for x; without
/// `transpose()`, `abs` or `normalized()`.
Mutations changed_words(const Source& source, Range range);

/// Other variables of the same type, and arguments of a call in another order.
Mutations changed_variables(const Source& source, const Function& function);

/// Statements that are left out, branches that are always or never taken, loops that run once,
/// results that are empty.
Mutations changed_statements(const Source& source, Range range);

/// Variables that start with another value: positive, never negative, in single precision, or
/// their value in the last call.
Mutations changed_starts(const Source& source, Range range);

} // namespace rigor::mutants
