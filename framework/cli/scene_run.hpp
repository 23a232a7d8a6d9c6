// SPDX-License-Identifier: MIT
// A scene run in the worker of an implementation, told record by record.
#pragma once

#include "grading/implementation.hpp"
#include "scene/run/run_scene.hpp"

#include <functional>
#include <span>
#include <string>

namespace rigor {

/// What to do with what comes; each may be empty.
struct SceneRun {
    Record record = Record::frames;
    int threads = 1; // that the reference may use
    std::function<void(std::span<const std::byte>)>
        on_bytes; // as they come, after they were understood
    std::function<void(const Scene&, const std::vector<RecordedBody>&)> on_start;
    std::function<void(const Frame&)> on_frame;
    std::function<void(const Counters&)> on_end;
};

struct RunOutcome {
    std::string failure;          // why it stopped early; empty: it is complete
    bool not_implemented = false; // a stub was called
    double seconds = 0;
};

/// Runs a scene. What the implementation does wrong ends the run and is told in the outcome; what
/// came before was handed on. @throws what the callbacks throw
RunOutcome run_in_worker(const Implementation& implementation, const Scene& scene,
                         const SceneRun& run);

/// Says on stderr why a run stopped early. @return the exit status
int report_outcome(const RunOutcome& outcome, const Implementation& implementation);

} // namespace rigor
