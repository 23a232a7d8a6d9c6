// SPDX-License-Identifier: MIT
// Runs the program as its users run it.
#pragma once

#include "grading/process.hpp"
#include "support/catch.hpp"

#include <string>
#include <vector>

namespace rigor::testing {

struct Run {
    int status = 0;
    std::string output;
};

/// @param arguments  the arguments after the program's name
/// @param only_stdout  whether to leave out what it writes to stderr
inline Run rigor(const std::vector<std::string>& arguments, bool only_stdout = false)
{
    Run result;
    Command command;
    command.shares_stderr = only_stdout;
    command.arguments = {std::string(RIGOR_BINARY_DIR) + "/bin/rigor"};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    const Ended ended =
        run(command, [&](std::string_view line) { result.output += std::string(line) + "\n"; });
    REQUIRE(ended.signal == 0);
    result.status = ended.status;
    return result;
}

} // namespace rigor::testing
