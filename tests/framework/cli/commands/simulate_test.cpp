// SPDX-License-Identifier: MIT
// `simulate --json` prints the hash of a motion, which is the same in every process, and `simulate
// --states` stores the motion as a table.
#include "framework/cli/command.hpp"
#include "support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

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

TEST_CASE("simulate: a table has the state of each body at each step", "[cli][scene]")
{
    if (!std::filesystem::is_directory(tree + "/reference")) return;
    const TemporaryFolder folder;
    folder.write("throw.json", R"({"time_step": 0.25, "end": 0.5, "bodies": [
        {"name": "floor", "shape": {"plane": {}}, "static": true, "position": [0, -9, 0]},
        {"name": "-ball, red", "shape": {"sphere": {"radius": 0.5}}, "mass": 10,
         "velocity": [-1, 2, 0], "angular_velocity": [0, 0, -3]}]})");
    const std::string scene = folder.path() / "throw.json", table = folder.path() / "states.csv";
    const Run run =
        rigor({"simulate", scene, "--with", "reference", "--every-step", "--states", table});
    CAPTURE(run.output);
    REQUIRE(run.status == 0);
    REQUIRE(run.output.find("states in " + table) != std::string::npos);
    std::ifstream file(table);
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);)
        lines.push_back(line);
    REQUIRE(lines.size() == 7); // a header, and two bodies at three times
    CHECK(lines[0] == "time,name,X.x,X.y,X.z,q.s,q.x,q.y,q.z,V.x,V.y,V.z,omega.x,omega.y,omega.z,"
                      "L.x,L.y,L.z\r");
    CHECK(lines[1] == "0,floor,0,-9,0,1,0,0,0,0,0,0,0,0,0,0,0,0\r");
    CHECK(lines[2] == "0,\"'-ball, red\",0,0,0,1,0,0,0,-1,2,0,0,0,-3,0,0,-3\r");
    CHECK(lines[6].starts_with("0.5,\"'-ball, red\",-0.5,"));
    // y = 2 t - ½ g t², and V = 2 - g t
    CHECK(lines[6].find(",-0.22625") != std::string::npos);
    CHECK(lines[6].find(",-2.905") != std::string::npos);
}

TEST_CASE("simulate: a table that cannot be written is refused in one line", "[cli][scene]")
{
    std::vector<std::string> arguments = {"simulate"};
    arguments.insert(arguments.end(), hammer.begin(), hammer.end());
    arguments.insert(arguments.end(), {"--states", "/nowhere/states.csv"});
    const Run run = rigor(arguments);
    CAPTURE(run.output);
    REQUIRE(run.status == 2);
    REQUIRE(run.output.find("/nowhere/states.csv: cannot be written\n") != std::string::npos);
}

} // namespace rigor::testing
