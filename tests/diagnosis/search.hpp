// SPDX-License-Identifier: MIT
// The search for one relation that explains all wrong answers of a formula.
#pragma once

#include "diagnosis/evidence.hpp"

namespace rigor::diagnosis {

/// What the wrong answers have in common, in words.
struct Finding {
    enum class Sort {
        relation,  // the answers follow from the right ones, or are right for other arguments
        condition, // they are wrong only for some arguments
        no_effect, // an argument has no effect on them
        part       // only a part of them is wrong
    };
    Sort sort = Sort::relation;
    std::string sentence; // "Your answer is twice the right one, on all 48 random inputs."
};

/// Searches for a relation that holds on every input. At least `enough` inputs must have a wrong
/// answer, so that the relation is no accident. Nothing if there is no such relation.
std::optional<Finding> explain(const Evidence& evidence, const Ask& student);

constexpr std::size_t enough = 6;

/// The condition on the arguments under which the answers are wrong, such as "`v`·`n` is negative".
/// Empty if no feature separates the wrong cases from the right ones.
std::string condition_of(const Layout& arguments, const std::vector<const Case*>& wrong,
                         const std::vector<const Case*>& right);

} // namespace rigor::diagnosis
