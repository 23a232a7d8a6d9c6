// SPDX-License-Identifier: MIT
#include "cli/scene_run.hpp"

#include "cli/command.hpp"
#include "errors/input_error.hpp"
#include "formulas/not_implemented.hpp"
#include "scene/trajectory/reader.hpp"
#include "worker/client.hpp"

#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace rigor {

namespace {

// The trajectory reader refused the bytes, which means that the worker wrote them wrongly.
struct Malformed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

} // namespace

RunOutcome run_in_worker(const Implementation& implementation, const Scene& scene,
                         const SceneRun& run)
{
    // Whether a handler runs. What a handler throws, for example because a picture cannot be drawn,
    // is not the worker's fault.
    bool in_handler = false;
    const auto handler = [&in_handler](auto handle) {
        return [&in_handler, handle](const auto&... record) {
            if (!handle) return;
            in_handler = true;
            handle(record...);
            in_handler = false;
        };
    };
    TrajectoryReader::Handlers handlers;
    handlers.on_start = handler(run.on_start);
    handlers.on_frame = handler(run.on_frame);
    handlers.on_end = handler(run.on_end);
    TrajectoryReader reader(handlers);
    RunOutcome outcome;
    const auto start = std::chrono::steady_clock::now();
    Limits limits;
    limits.scene_by_silence = true; // the limit is for each wait between two parts of the stream
    limits.scene = std::chrono::duration<double>(10);
    try {
        Worker worker(implementation.worker, limits);
        worker.run_scene(
            scene.text, scene.name, run.record,
            [&](std::span<const std::byte> bytes) {
                try {
                    reader.feed(bytes);
                } catch (const InputError& error) {
                    if (in_handler) throw;
                    throw Malformed(error.what());
                }
                if (run.on_bytes) run.on_bytes(bytes);
            },
            run.threads);
        if (!reader.complete()) outcome.failure = "the run stopped before its end";
    } catch (const NotImplemented& stub) {
        outcome.failure = describe(stub);
        outcome.not_implemented = true;
    } catch (const FormulaMissing& missing) {
        outcome.failure = missing.what();
        outcome.missing = true;
    } catch (const WorkerFailure& failure) {
        outcome.failure = failure.what();
    } catch (const NotFinite& failure) {
        outcome.failure = failure.what();
    } catch (const Malformed& failure) {
        outcome.failure = failure.what();
    }
    outcome.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return outcome;
}

int report_outcome(const RunOutcome& outcome, const Implementation& implementation)
{
    if (outcome.failure.empty()) return exit_done;
    std::fprintf(stderr, "rigor: %s: %s\n", implementation.name.c_str(), outcome.failure.c_str());
    return outcome.missing ? exit_input : exit_wrong;
}

} // namespace rigor
