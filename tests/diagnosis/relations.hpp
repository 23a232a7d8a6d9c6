// SPDX-License-Identifier: MIT
// Relations of wrong answers to the right ones. A relation holds for all pairs or is not reported.
#pragma once

#include "diagnosis/evidence.hpp"
#include "diagnosis/features.hpp"

namespace rigor::diagnosis {

/// The answers at one place.
struct Pair {
    std::span<const double> right, answer;
    const Value* arguments = nullptr;
    double noise = 0;
};
struct Pairs {
    const Role& role;
    std::vector<Pair> list;
};

/// The pairs of one place in these cases. Cases whose answers have other sizes have none.
Pairs pairs_of(const Layout& answer, int role, const std::vector<const Case*>& cases);

/// What the answers are, from the right ones alone: "twice the right one", "always 0". The words
/// complete "your answer is". Empty if nothing holds for all.
std::string plain_relation(const Pairs& pairs);

/// The argument that the answers are, or a multiple of it: "-`v`".
std::string argument_itself(const Pairs& pairs, const Layout& arguments);

/// What the answers are, from the right ones and the arguments: "the right one divided by `mass`".
std::string relation_to_arguments(const Pairs& pairs, const Layout& arguments,
                                  const std::vector<Feature>& features);

/// Which part of the answers is right although the whole is not: "right on the diagonal only".
std::string right_part(const Pairs& pairs);

/// A number as people write it: "½", "-1", "π/4", "1.234".
std::string number_in_words(double number);

} // namespace rigor::diagnosis
