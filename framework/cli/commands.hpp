// SPDX-License-Identifier: MIT
// The commands. Each has a file of its own; commands.cpp lists them all.
#pragma once

#include <functional>
#include <span>

namespace rigor {

class Options;

/// What a command does once its options are read. @return the exit status
using Action = std::function<int()>;

struct CommandEntry {
    const char* name;
    const char* summary;
    Action (*declare)(Options& options);
};

std::span<const CommandEntry> commands();

Action declare_bench(Options& options);
Action declare_check(Options& options);
Action declare_compare(Options& options);
Action declare_demo(Options& options);
Action declare_list(Options& options);
Action declare_render(Options& options);
Action declare_simulate(Options& options);
Action declare_test(Options& options);

/// Exit statuses.
enum Exit : int {
    exit_done = 0,  // also when a submission failed its tests: that is a result
    exit_wrong = 1, // what was checked is wrong
    exit_input = 2, // bad usage or bad input
    exit_fault = 3, // a fault of the framework's own
};

/// Reads the command line and runs its command. @return the exit status
int run_command_line(int argc, char** argv);

} // namespace rigor
