// SPDX-License-Identifier: MIT
// Every formula of the table without its types: how its arguments are drawn, and what they and its
// answer consist of.
#pragma once

#include "diagnosis/layout.hpp"

namespace rigor::diagnosis {

struct FormulaType {
    Layout arguments, answer;
    std::size_t largest; // size of an encoded answer [bytes]
    /// Random arguments of the formula, encoded.
    Bytes (*draw)(unsigned seed);
    /// What is unique in an answer whose parts may be in any order; nullptr if all of it is.
    Value (*unique)(std::span<const std::byte> answer);

    /// @throws wire::Malformed
    Value decode_answer(std::span<const std::byte> bytes) const
    {
        return unique ? unique(bytes) : answer.decode(bytes);
    }
};

const FormulaType& type_of(FormulaIndex formula);

/// The index of the formula with this tag. Empty if the task has none.
std::optional<FormulaIndex> formula_with(std::string_view tag);

} // namespace rigor::diagnosis
