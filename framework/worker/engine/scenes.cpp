// SPDX-License-Identifier: MIT
// Runs scenes with the formulas of the implementation. For a client that grades, the engine's own
// results are discarded: what counts are the answers of the formulas, in the order of the calls.
#include "worker/engine/scenes.hpp"

#include "rigid/bodies/non_finite.hpp"
#include "scene/keys/scene_keys.hpp"
#include "scene/run/run_scene.hpp"
#include "scene/trajectory/trajectory.hpp"
#include "worker/engine/answers.hpp"

#include <algorithm>
#include <optional>

namespace rigor {

namespace {

// If answers are streamed, the reference runs like any other implementation, on one thread and
// without faster forms, because the client's engine takes one answer after the other.
RunSettings settings(const SceneRequest& request)
{
    if (!request.is_reference || request.options.streams_answers) return {};
    return {.formulas_are_reference = true,
            .threads = std::clamp<int>(request.options.threads, 1, 64)};
}

wire::Bytes advance_states(const SceneRequest& request)
{
    wire::Reader reader(request.payload);
    std::string text, name;
    int steps = 0;
    std::vector<Moment> starts;
    wire::decode(reader, text);
    wire::decode(reader, name);
    wire::decode(reader, steps);
    wire::decode(reader, starts);
    reader.end();
    const auto states = advance(parse_scene(text, name), starts, steps, settings(request));
    wire::Bytes result;
    wire::encode(result, states);
    return result;
}

void run(const SceneRequest& request, const Stream& stream)
{
    wire::Reader reader(request.payload);
    std::string text, name;
    wire::decode(reader, text);
    wire::decode(reader, name);
    reader.end();
    const Record record = request.options.every_step ? Record::every_step : Record::frames;
    const bool hides_trajectory = request.options.streams_answers;
    run_scene(
        parse_scene(text, name), record,
        [&](std::span<const std::byte> bytes) {
            if (!hides_trajectory) stream(bytes);
        },
        settings(request));
}

} // namespace

void rigor_run_scenes(const SceneRequest& request, const Stream& stream, wire::Bytes& result)
{
    std::optional<StreamAnswers> answers;
    if (request.options.streams_answers) answers.emplace(stream, request.given, request.take);
    try {
        if (request.kind == Request::advance)
            result = advance_states(request);
        else
            run(request, stream);
    } catch (const NonFiniteState& state) {
        throw NonFiniteAnswer{state.what()};
    }
}

} // namespace rigor
