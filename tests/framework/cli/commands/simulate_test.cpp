// SPDX-License-Identifier: MIT
// `simulate --json` prints the hash of a motion, which is the same in every process.
#include "framework/cli/command.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace rigor::testing {

namespace {

const std::string tree = RIGOR_SOURCE_DIR;
const std::vector<std::string> hammer = {"a2-inertia/hammer", "--with",
                                         tree + "/tests/samples/complete"};

std::string hash_of(const std::vector<std::string>& scene,
                    const std::vector<std::string>& more = {})
{
    std::vector<std::string> arguments = {"simulate", "--json"};
    arguments.insert(arguments.end(), scene.begin(), scene.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run run = rigor(arguments);
    CAPTURE(run.output);
    REQUIRE(run.status == 0);
    const std::string& output = run.output;
    return nlohmann::json::parse(output.substr(output.find('{')))["hash"];
}

} // namespace

TEST_CASE("determinism: simulate tells the same hash every time", "[cli][scene]")
{
    const std::string hash = hash_of(hammer);
    REQUIRE(hash.size() == 16);
    REQUIRE(hash.find_first_not_of("0123456789abcdef") == std::string::npos);
    REQUIRE(hash_of(hammer) == hash);
    REQUIRE(hash_of(hammer, {"--every-step"}) != hash); // more frames were recorded
}

TEST_CASE("determinism: simulate tells the same hash for any number of threads", "[cli][scene]")
{
    if (!std::filesystem::is_directory(tree + "/reference")) return;
    const std::vector<std::string> scene = {"a4-collision/billiard_break", "--with", "reference"};
    const std::string hash = hash_of(scene);
    REQUIRE(hash_of(scene, {"--threads", "2"}) == hash);
    REQUIRE(hash_of(scene, {"--threads", "3"}) == hash);
}

} // namespace rigor::testing
