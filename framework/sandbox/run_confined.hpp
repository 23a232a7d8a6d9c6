// SPDX-License-Identifier: MIT
// Runs a program in a sandbox to its end, within limits on time and output.
#pragma once

#include "sandbox/confined.hpp"

#include <chrono>

namespace rigor {

struct RunLimits {
    std::chrono::duration<double> time{60};    // wall-clock time of launcher and program [s]
    std::size_t output = std::size_t{1} << 20; // how much the program may print [bytes]
    // How much of the output is kept, from its beginning [bytes].
    std::size_t output_kept = std::size_t{256} << 10;
};

/// How a run ended.
struct ConfinedRun {
    int status = 0; // the program's exit status; stays 0 if the program was killed
    int signal = 0; // the signal that killed the program, or 0
    std::optional<int> blocked_call;
    // Whether the program took more time, or printed more, than its limits allow.
    bool timed_out = false, flooded = false;
    bool stopped = false; // whether it stopped itself
    std::string output;   // the beginning of stdout and stderr together, in order
    double seconds = 0;   // wall-clock time of launcher and program [s]
    // How many processes of the whole machine the kernel has ended meanwhile for want of memory.
    std::uint64_t oom_kills = 0;
    double processor_seconds = 0; // processor time of the program and of all that it started [s]

    bool ok() const
    {
        return status == 0 && signal == 0 && !blocked_call && !timed_out && !flooded && !stopped;
    }
};

/// Runs a program until it ends, exceeds a limit of `limits`, makes a blocked call or stops itself.
/// Then the program and all that it started are ended.
/// @param input  a descriptor that becomes its stdin; -1 for an empty one
/// @throws std::system_error if the program cannot be started in this sandbox
ConfinedRun run_confined(const Confinement& confinement, const std::vector<std::string>& arguments,
                         const RunLimits& limits = {}, int input = -1);

} // namespace rigor
