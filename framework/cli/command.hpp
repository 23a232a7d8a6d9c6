// SPDX-License-Identifier: MIT
// What a command is: it declares its options, acts, and ends with an exit status.
#pragma once

#include <functional>

namespace rigor {

class Options;

/// What a command does once its options are read. @return the exit status
using Action = std::function<int()>;

/// Exit statuses.
enum Exit : int {
    exit_done = 0,  // also when a submission failed its tests: that is a result
    exit_wrong = 1, // what was checked is wrong
    exit_input = 2, // bad usage or bad input
    exit_fault = 3, // a fault of the framework's own
};

} // namespace rigor
