// SPDX-License-Identifier: MIT
// `simulate --json` tells the hash of a motion: the same in every process.
#include "grading/process.hpp"
#include "support/catch.hpp"

#include <nlohmann/json.hpp>

namespace rigor::testing {

namespace {

std::string hash_of(const std::vector<std::string>& more = {})
{
    std::string output;
    Command command;
    command.arguments = {std::string(RIGOR_BINARY_DIR) + "/bin/rigor",
                         "simulate",
                         "a2-inertia/hammer",
                         "--with",
                         std::string(RIGOR_SOURCE_DIR) + "/tests/samples/complete",
                         "--json"};
    command.arguments.insert(command.arguments.end(), more.begin(), more.end());
    const Ended ended =
        run(command, [&](std::string_view line) { output += std::string(line) + "\n"; });
    CAPTURE(output);
    REQUIRE(ended.ok());
    return nlohmann::json::parse(output.substr(output.find('{')))["hash"];
}

} // namespace

TEST_CASE("determinism: simulate tells the same hash every time", "[cli][scene]")
{
    const std::string hash = hash_of();
    REQUIRE(hash.size() == 16);
    REQUIRE(hash.find_first_not_of("0123456789abcdef") == std::string::npos);
    REQUIRE(hash_of() == hash);
    REQUIRE(hash_of({"--every-step"}) != hash); // more frames were recorded
}

} // namespace rigor::testing
