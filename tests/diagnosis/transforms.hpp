// SPDX-License-Identifier: MIT
// Changes of the arguments that a mistake may amount to: a wrong answer is often the right one for
// other arguments, such as the transpose of a matrix or two arguments in each other's place.
#pragma once

#include "diagnosis/layout.hpp"

#include <functional>

namespace rigor::diagnosis {

struct Transform {
    std::string words;  // "`R` transposed"
    std::string advice; // "a transpose may be missing"; may be empty
    /// Changes the arguments. @return false if these arguments cannot be changed so
    std::function<bool(Value&)> apply;
    int strangeness = 0; // 1 for a change that few mistakes amount to
};

/// The changes of arguments of these types, the simplest first.
std::vector<Transform> transforms(const Layout& arguments);

/// A change of the numbers of one place; those of a matrix are in the order of its columns.
struct LeafChange {
    std::string words, advice;
    std::function<bool(std::span<double>)> apply;
};

/// The changes of one place by itself.
std::vector<LeafChange> changes_of(const Role& role);

/// A change of the numbers of one place by those of another.
struct PairChange {
    std::string words, advice; // the words name both places
    std::function<bool(std::span<double>, std::span<double>)> apply;
};

std::vector<PairChange> changes_of(const Role& changed, const Role& by);

} // namespace rigor::diagnosis
