// SPDX-License-Identifier: MIT
// Whoever starts a grader may ignore SIGCHLD, and the grader then begins with this signal ignored.
#include "confine.hpp"
#include "support/catch.hpp"

#include <csignal>
#include <cstdlib>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

using namespace testing;

namespace {

constexpr const char* expected_tier = "RIGOR_TEST_EXPECTED_TIER";

} // namespace

TEST_CASE("sandbox: the end of a program is known even if SIGCHLD was ignored")
{
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        const Confinement walls = confinement(Profile::worker, tier);
        for (const char* name : {"exit", "abort", "user"}) {
            std::signal(SIGCHLD, SIG_IGN);
            const ConfinedRun run = run_attempt(walls, name);
            CAPTURE(name);
            CHECK(run.status == (name == std::string("exit") ? 3 : 0));
            CHECK(run.signal == (name == std::string("abort") ? SIGABRT : 0));
            CHECK_FALSE(run.timed_out);
        }
    }
}

// The walls that are possible are found out once in each process. So this test starts itself anew.
TEST_CASE("sandbox: as many walls are possible if SIGCHLD is ignored")
{
    const std::string tier = description(strongest(possible_walls()));
    if (const char* expected = std::getenv(expected_tier)) {
        CHECK(tier == expected);
        return;
    }
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGCHLD, SIG_IGN);
        setenv(expected_tier, tier.c_str(), 1);
        execl("/proc/self/exe", "test_sandbox",
              "sandbox: as many walls are possible if SIGCHLD is ignored", nullptr);
        _exit(127);
    }
    int status = -1;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(status == 0);
}

} // namespace rigor
