// SPDX-License-Identifier: MIT
// How the launcher ends if a part of the sandbox (a wall) cannot be put up: it never starts the
// program with fewer walls than it was asked for.
#pragma once

#include <string>

namespace rigor::confine {

/// The descriptor of the socket to the grader; -1 if there is none, as with the option --probe.
inline int report_socket = -1;

/// Reports the errno of the action that failed and ends this process.
[[noreturn]] void fail(const std::string& action);

/// @return the result of a system call. If it is negative, this process ends with a report.
template <class Result> Result must(Result result, const char* action)
{
    if (result < 0) fail(action);
    return result;
}

/// Reports that the sandbox is up, and attaches the listener of blocked calls, unless `listener` is
/// negative. If the grader has died, this process ends.
void report_ready(int listener);

} // namespace rigor::confine
