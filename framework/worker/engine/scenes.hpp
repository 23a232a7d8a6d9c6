// SPDX-License-Identifier: MIT
// The engine's part of a worker. This part is first linked alone, and its names are made local. The
// same is done with the part that has the main function. So an implementation, which is linked to
// these parts later, can neither replace a function of the engine nor call one.
#pragma once

#include "worker/engine/answers.hpp"
#include "worker/protocol/channel.hpp"
#include "worker/protocol/wire.hpp"

#include <string>

namespace rigor {

/// Thrown when a state in a scene has a number that is not finite. The text names the body, the
/// quantity and the time.
struct NonFiniteAnswer {
    std::string text;
};

struct SceneRequest {
    Request kind; // run_scene or advance
    SceneOptions options;
    std::span<const std::byte> payload;
    /// Whether the implementation is the reference. Then the engine may use its faster forms of the
    /// formulas, and several threads: other implementations may not be thread-safe.
    bool is_reference;
    /// The formulas whose answers the client gives, if answers are streamed, and the function that
    /// takes one of these answers.
    FormulaSet given;
    TakeAnswer take;
};

extern "C" {
/// Does what the request asks for:
/// - `run_scene`: runs a scene and streams its trajectory, or instead the answers of the formulas
///   (`SceneOptions::streams_answers`). `result` is left as it is.
/// - `advance`: does time steps from given states. `result` becomes the encoded states after them.
/// @throws NonFiniteAnswer, wire::Malformed, what a formula throws
void rigor_run_scenes(const SceneRequest& request, const Stream& stream, wire::Bytes& result);
}

} // namespace rigor
