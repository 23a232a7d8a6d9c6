// SPDX-License-Identifier: MIT
// Grading where the kernel allows no walls (no sandbox): hidden tests are left out, unless the user
// asks for them by RIGOR_TIER=C.
#include "command.hpp"
#include "grading/places.hpp"

namespace rigor::testing {

namespace {

// Runs the program without walls. @param tier  RIGOR_TIER, empty for none
Run without_walls(const std::string& tier, const std::vector<std::string>& arguments)
{
    Command command;
    const std::string programs = std::string(RIGOR_BINARY_DIR) + "/bin/";
    command.arguments = {"/usr/bin/env", tier.empty() ? "--unset=RIGOR_TIER" : "RIGOR_TIER=" + tier,
                         programs + "without_walls", programs + "rigor"};
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    return run_command(command);
}

bool says(const Run& run, const std::string& text)
{
    return run.output.find(text) != std::string::npos;
}

const std::vector<std::string> checked = {"check", "A2.14", "A2.16", "--with",
                                          RIGOR_SOURCE_DIR "/tests/samples/complete"};

} // namespace

TEST_CASE("weak walls: without walls hidden tests are left out, and the user is told")
{
    if (!places().has_reference()) return; // a student's tree has no hidden tests
    const Run run = without_walls("", checked);
    CAPTURE(run.output);
    REQUIRE(run.status == 0);
    REQUIRE(says(run, "walls around it: C: limits on resources only"));
    REQUIRE(says(run, "no walls are possible here: hidden tests are left out"));
    REQUIRE(says(run, "hidden, run by the course"));
}

TEST_CASE("weak walls: hidden tests run without walls for a user who asks for it")
{
    if (!places().has_reference()) return;
    const Run run = without_walls("C", checked);
    CAPTURE(run.output);
    REQUIRE(run.status == 0);
    REQUIRE(says(run, "walls around it: C: limits on resources only"));
    REQUIRE_FALSE(says(run, "hidden tests are left out"));
    REQUIRE_FALSE(says(run, "hidden, run by the course"));
}

TEST_CASE("weak walls: walls that are not possible are refused")
{
    const Run run = without_walls("B", checked);
    CAPTURE(run.output);
    REQUIRE(run.status == 2);
    REQUIRE(says(run, "this machine and user allow no more than C"));
}

} // namespace rigor::testing
