// SPDX-License-Identifier: MIT
// Runs the program as its users run it.
#pragma once

#include "grading/process.hpp"
#include "support/catch.hpp"

#include <string>
#include <utility>
#include <vector>

namespace rigor::testing {

struct Run {
    int status = 0;
    std::string output; // without the note that `rigor` waited for another `rigor` that builds
};

/// The output without the lines which say that `rigor` waits for another `rigor` that builds. Such
/// a line depends on which other tests run at the same time.
inline std::string without_waiting(std::string output)
{
    const std::string waits = "rigor: another rigor is building; waiting for it\n";
    for (std::size_t at = output.find(waits); at != std::string::npos; at = output.find(waits))
        output.erase(at, waits.size());
    return output;
}

inline Run run_command(const Command& command)
{
    std::string output;
    const Ended ended = run(command, [&](std::string_view line) { output.append(line) += '\n'; });
    REQUIRE(ended.signal == 0);
    return {ended.status, without_waiting(std::move(output))};
}

/// @param arguments  the arguments after the program's name
/// @param only_stdout  whether to leave out what the program writes to stderr
inline Run rigor(const std::vector<std::string>& arguments, bool only_stdout = false)
{
    Command command;
    command.shares_stderr = only_stdout;
    command.arguments = {std::string(RIGOR_BINARY_DIR) + "/bin/rigor"};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    return run_command(command);
}

} // namespace rigor::testing
