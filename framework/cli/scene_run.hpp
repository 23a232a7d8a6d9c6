// SPDX-License-Identifier: MIT
// A scene that runs in the worker of an implementation and is reported record by record.
#pragma once

#include "grading/build/implementation.hpp"
#include "scene/run/run_scene.hpp"

#include <functional>
#include <span>
#include <string>

namespace rigor {

/// What to record, and the callbacks that take the records. Each callback may be empty.
struct SceneRun {
    Record record = Record::frames;
    int threads = 1; // threads of the reference; others use one
    /// Takes the bytes of the trajectory after the reader has accepted them.
    std::function<void(std::span<const std::byte>)> on_bytes;
    std::function<void(const Scene&, const std::vector<RecordedBody>&)> on_start;
    std::function<void(const Frame&)> on_frame;
    std::function<void(const Counters&)> on_end;
};

struct RunOutcome {
    std::string failure;          // why the run stopped early; empty if it is complete
    bool not_implemented = false; // a stub was called
    double seconds = 0;
};

/// Runs a scene. A failure of the implementation ends the run and is reported in the outcome; the
/// callbacks have already received the records before it. @throws what the callbacks throw
RunOutcome run_in_worker(const Implementation& implementation, const Scene& scene,
                         const SceneRun& run);

/// Prints on stderr why a run stopped early. @return the exit status
int report_outcome(const RunOutcome& outcome, const Implementation& implementation);

} // namespace rigor
