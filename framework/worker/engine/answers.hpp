// SPDX-License-Identifier: MIT
// The formulas as the worker's engine calls them: each call is passed on to the implementation, and
// its answer can be streamed to the client, whose own engine takes the same steps.
#pragma once

#include "formulas/table.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace rigor {

using AnyFormula = void (*)();

/// Takes a part of what a scene streams.
using Stream = std::function<void(std::span<const std::byte>)>;

extern "C" {
/// The implementation's formulas, in the order of the table. They are defined in the part of the
/// worker with the main function.
extern const AnyFormula rigor_formulas[];
}

/// Waits for the next encoded answer that the client gives, and copies it to `answer`.
using TakeAnswer = std::function<void(FormulaIndex formula, std::vector<std::byte>& answer)>;

/// As long as this object lives, each answer of a formula is streamed to the client. The formulas
/// in `given` are excepted: the client gives their answers.
class StreamAnswers {
public:
    StreamAnswers(const Stream& stream, const FormulaSet& given, const TakeAnswer& take);
    ~StreamAnswers();
    StreamAnswers(const StreamAnswers&) = delete;
    StreamAnswers& operator=(const StreamAnswers&) = delete;
};

} // namespace rigor
