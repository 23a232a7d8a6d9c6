// SPDX-License-Identifier: MIT
// The engine's part of a worker. It is linked beforehand, with local names, and so is the main
// function's part: an implementation can neither replace a function of the engine nor call one.
#pragma once

#include "worker/engine/answers.hpp"
#include "worker/protocol/channel.hpp"
#include "worker/protocol/wire.hpp"

#include <string>

namespace rigor {

/// A state of a scene that is not finite. The text names the body, the quantity and the time.
struct NonFiniteAnswer {
    std::string text;
};

struct SceneRequest {
    Request kind; // run_scene or advance
    SceneOptions options;
    std::span<const std::byte> payload;
    /// Whether the implementation is the reference, so that the engine's faster forms of its
    /// formulas may be used. Other formulas may not be safe to call from several threads either.
    bool is_reference;
    /// The formulas whose answers the client gives while answers are streamed, and how to take one.
    FormulaSet given;
    TakeAnswer take;
};

extern "C" {
/// Runs a scene and streams what the request asks for. `result` becomes the answer.
/// @throws NonFiniteAnswer, wire::Malformed, what a formula throws
void rigor_run_scenes(const SceneRequest& request, const Stream& stream, wire::Bytes& result);
}

} // namespace rigor
