// SPDX-License-Identifier: MIT
// Runs a program to its end, within limits, and takes its output line by line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A program to run.
struct Command {
    std::vector<std::string> arguments; // first the program, which is looked up in PATH
    std::filesystem::path folder;       // working directory; empty for the current one
    double silence = 0;       // longest time without output or message [s]; 0 for no limit
    std::uint64_t memory = 0; // limit on the address space [bytes]; 0 for no limit
    std::vector<std::string> environment; // "NAME=value", in addition to what is inherited
    bool shares_stderr = false;           // whether its stderr is that of this process
};

/// How a program ended.
struct Ended {
    int status = 0;         // its exit status
    int signal = 0;         // the signal that killed it, or 0
    bool timed_out = false; // whether it was ended because it printed nothing for too long
    double seconds = 0;     // wall-clock time from start to end [s]

    bool ok() const { return status == 0 && signal == 0 && !timed_out; }
};

using OnLine = std::function<void(std::string_view line)>;

/// Runs a program with an empty stdin. Each line of its stdout goes to `on_output`, and so does
/// each line of its stderr, unless the command has `shares_stderr`. Each line that the program
/// writes to the descriptor `message_descriptor` goes to `on_message`. The program is ended when
/// this process ends.
///
/// A line longer than 1 MiB is passed on in pieces. @throws std::runtime_error if the program
/// cannot be started
Ended run(const Command& command, const OnLine& on_output, const OnLine& on_message = {});

/// Whether a program of this name is in PATH.
bool is_installed(const std::string& program);

/// The descriptor to which the program of `run` writes the lines for `on_message`.
inline constexpr int message_descriptor = 3;

} // namespace rigor
