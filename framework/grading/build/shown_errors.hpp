// SPDX-License-Identifier: MIT
// What a student sees of the messages of a compiler, an assembler or a linker.
#pragma once

#include "sandbox/run_confined.hpp"

#include <string>

namespace rigor {

/// The first errors in what a tool printed, without control characters and without the paths of
/// this machine. Each line begins with a bar. Limits that a student cannot change are told in plain
/// words, without the names of options.
std::string shown_errors(const std::string& output);

/// The limits of a tool that is run for a submission.
enum class ToolLimit { none, file_size, memory, time };

/// Which limit a tool has exceeded, judged by the signal that ended it and by its output, which
/// names the signal that ended a program that the tool started.
/// @param time  the limit on its processor time [s]
ToolLimit limit_met(const ConfinedRun& run, double time);

} // namespace rigor
