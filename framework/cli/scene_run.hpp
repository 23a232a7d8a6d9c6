// SPDX-License-Identifier: MIT
// Runs a scene in the worker of an implementation, which is a separate process, and passes on each
// record of the trajectory.
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
    int threads = 1; // number of threads of the reference; student code uses one thread
    /// Takes the bytes of the trajectory after the `TrajectoryReader` has accepted them.
    std::function<void(std::span<const std::byte>)> on_bytes;
    std::function<void(const Scene&, const std::vector<RecordedBody>&)> on_start;
    std::function<void(const Frame&)> on_frame;
    std::function<void(const Counters&)> on_end;
};

struct RunOutcome {
    std::string failure;          // why the run stopped early; empty if the run is complete
    bool not_implemented = false; // whether a formula was called that is still a stub
    bool missing = false;         // whether a formula was called that is not defined
    double seconds = 0;           // how long the run took, by the wall clock
};

/// Runs a scene. A failure of the implementation ends the run and is reported in the outcome. The
/// callbacks have received all records that were made before the failure.
/// @throws what the callbacks throw
RunOutcome run_in_worker(const Implementation& implementation, const Scene& scene,
                         const SceneRun& run);

/// Prints on stderr why a run stopped early. @return the exit status
int report_outcome(const RunOutcome& outcome, const Implementation& implementation);

} // namespace rigor
