// SPDX-License-Identifier: MIT
// Runs a program behind walls to its end, within limits on time and output.
#pragma once

#include "sandbox/confined.hpp"

#include <chrono>

namespace rigor {

struct RunLimits {
    std::chrono::duration<double> time{60};           // from start to end
    std::size_t output = std::size_t{1} << 20;        // what it may print [bytes]
    std::size_t output_kept = std::size_t{256} << 10; // kept beginning of the output [bytes]
};

/// How a run ended.
struct ConfinedRun {
    int status = 0; // its exit status
    int signal = 0; // the signal that killed it, or 0
    std::optional<int> blocked_call;
    bool timed_out = false, flooded = false; // whether it was ended for its time or its output
    std::string output;                      // the beginning of its stdout and stderr, in order
    double seconds = 0;                      // from start to end
    double processor_seconds = 0;            // used by it and by all that it started

    bool ok() const
    {
        return status == 0 && signal == 0 && !blocked_call && !timed_out && !flooded;
    }
};

/// Runs a program. When it ends, all that it started is ended too.
/// @param input  a descriptor that becomes its stdin; -1 for an empty one
/// @throws std::system_error if it cannot be started behind these walls
ConfinedRun run_confined(const Confinement& confinement, const std::vector<std::string>& arguments,
                         const RunLimits& limits = {}, int input = -1);

} // namespace rigor
