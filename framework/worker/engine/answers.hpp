// SPDX-License-Identifier: MIT
// The formulas as the worker's engine calls them. Each call is passed on to the implementation,
// apart from the formulas that the client answers. The implementation's answer can also be streamed
// to the client, which runs the same scene with an engine of its own.
#pragma once

#include "formulas/table.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace rigor {

using AnyFormula = void (*)();

/// A function that takes the next part of what a scene streams to the client.
using Stream = std::function<void(std::span<const std::byte>)>;

extern "C" {
/// The implementation's formulas, in the order of the table in formulas/table.hpp. This array is
/// defined in worker/main/dispatch.cpp.
extern const AnyFormula rigor_formulas[];
}

/// Waits for the next encoded answer that the client sends in place of the implementation, and
/// copies it to `answer`.
using TakeAnswer = std::function<void(FormulaIndex formula, std::vector<std::byte>& answer)>;

/// As long as this object lives, each answer of a formula is streamed to the client. The formulas
/// in `given` are excepted: their answers come from the client, by `take`.
class StreamAnswers {
public:
    StreamAnswers(const Stream& stream, const FormulaSet& given, const TakeAnswer& take);
    ~StreamAnswers();
    StreamAnswers(const StreamAnswers&) = delete;
    StreamAnswers& operator=(const StreamAnswers&) = delete;
};

} // namespace rigor
