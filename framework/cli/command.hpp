// SPDX-License-Identifier: MIT
// A command of `rigor`: it declares its options, acts, and returns an exit status.
#pragma once

#include <functional>

namespace rigor {

class Options;

/// The work of a command, called after its options have been read. @return the exit status
using Action = std::function<int()>;

/// Exit statuses.
enum Exit : int {
    exit_done = 0,  // the command did its work
    exit_wrong = 1, // points are missing, a test or a run failed, or two runs differ
    exit_input = 2, // wrong options or input, or a scene called a formula that is not defined
    exit_fault = 3, // an internal error of the framework
};

} // namespace rigor
