// SPDX-License-Identifier: MIT
// `rigor check`, run as a user runs it.
#pragma once

#include "../grading/files.hpp"
#include "grading/process.hpp"
#include "support/catch.hpp"

#include <nlohmann/json.hpp>

#include <sstream>
#include <vector>

namespace rigor::testing {

using nlohmann::json;

struct Checked {
    int status = 0;
    json result;
};

/// Checks an implementation. @param what  as on the command line
inline Checked check(const std::vector<std::string>& what, const std::filesystem::path& with)
{
    const TemporaryFolder results;
    const auto file = results.path() / "result.json";
    Command command;
    command.arguments = {std::string(RIGOR_BINARY_DIR) + "/bin/rigor",
                         "check",
                         "--with",
                         with.string(),
                         "--out",
                         file.string()};
    command.arguments.insert(command.arguments.end(), what.begin(), what.end());
    std::string output;
    const Ended ended =
        run(command, [&](std::string_view line) { output += std::string(line) + "\n"; });
    CAPTURE(output);
    REQUIRE(std::filesystem::exists(file));
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return {ended.status, json::parse(text.str())};
}

} // namespace rigor::testing
