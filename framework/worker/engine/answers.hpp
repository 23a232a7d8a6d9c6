// SPDX-License-Identifier: MIT
// The formulas as the worker's engine calls them: each call is passed on to the implementation, and
// its answer can be streamed to the client, whose own engine takes the same steps.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

namespace rigor {

using AnyFormula = void (*)();

/// Takes a part of what a scene streams.
using Stream = std::function<void(std::span<const std::byte>)>;

extern "C" {
/// The implementation's formulas, in the order of the table. They are defined in the part of the
/// worker with the main function.
extern const AnyFormula rigor_formulas[];
}

/// Streams the answer of each formula as long as this object lives.
class StreamAnswers {
public:
    explicit StreamAnswers(const Stream& stream);
    ~StreamAnswers();
    StreamAnswers(const StreamAnswers&) = delete;
    StreamAnswers& operator=(const StreamAnswers&) = delete;
};

} // namespace rigor
