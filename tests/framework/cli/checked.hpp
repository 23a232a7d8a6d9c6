// SPDX-License-Identifier: MIT
// `rigor check`, run as a user runs it.
#pragma once

#include "command.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

namespace rigor::testing {

using nlohmann::json;

struct Checked {
    int status = 0;
    json result;
    std::string said; // the output on the terminal
};

/// Checks an implementation. @param what  the tasks, as on the command line
inline Checked check(const std::vector<std::string>& what, const std::filesystem::path& with)
{
    const TemporaryFolder results;
    const auto file = results.path() / "result.json";
    std::vector<std::string> arguments = {"check", "--with", with.string(), "--out", file.string()};
    arguments.insert(arguments.end(), what.begin(), what.end());
    const Run run = rigor(arguments);
    CAPTURE(run.output);
    REQUIRE(std::filesystem::exists(file));
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return {run.status, json::parse(text.str()), run.output};
}

} // namespace rigor::testing
