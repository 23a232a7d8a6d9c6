// SPDX-License-Identifier: MIT
// Tests of the walls around a worker: what is blocked is named, in each tier with walls that is
// possible here. In tier C, without walls, the same attempts succeed, so the program does try.
#include "confine.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <csignal>
#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

using namespace testing;

namespace {

struct Blocked {
    std::string attempt, about, words;
};

std::vector<Blocked> blocked_attempts(const std::string& folder)
{
    const std::string parent = std::to_string(getpid());
    return {
        {"socket", "", "open a network socket"},
        {"read", "/etc/passwd", "open a file"},
        {"read", std::string(RIGOR_SOURCE_DIR) + "/README.md", "open a file"},
        {"read", "/proc/" + parent + "/mem", "open a file"},
        {"read", "/proc/self/mem", "open a file"},
        {"write", folder + "/file", "open a file"},
        {"list", RIGOR_SOURCE_DIR, "open a file"},
        {"execute", program("hello"), "start another program"},
        {"execute like the launcher", program("hello"), "start another program"},
        {"execute from memory", program("hello"), "make a file in memory"},
        {"fork", "", "start a thread or another process"},
        {"daemons", "", "start a thread or another process"},
        {"read memory", parent, "look into another process"},
        {"signal", parent, "send a signal to a process"},
        {"executable memory", "", "make memory executable"},
        {"make executable", "", "make memory executable"},
        {"shared memory", "", "share memory with other processes"},
        {"make a folder", folder + "/folder", "change files"},
        {"handle SIGSYS", "", "open a network socket"},
    };
}

} // namespace

TEST_CASE("sandbox: what a worker must not do is blocked and named")
{
    const TemporaryFolder folder;
    chmod(folder.path().c_str(), 0777);
    for (const Tier tier : walled_tiers())
        for (const Blocked& expected : blocked_attempts(folder.path())) {
            CAPTURE(description(tier), expected.attempt, expected.about);
            const ConfinedRun run =
                run_attempt(confinement(Profile::worker, tier), expected.attempt, expected.about);
            CAPTURE(run.output, run.status, run.signal);
            if (possible_walls().listener)
                REQUIRE(blocked(run) == expected.words);
            else
                REQUIRE(run.signal == SIGSYS);
            REQUIRE(run.output.empty());
            REQUIRE(std::filesystem::is_empty(folder.path()));
        }
}

TEST_CASE("sandbox: without walls the same attempts succeed")
{
    const TemporaryFolder folder;
    for (const Blocked& attempt : blocked_attempts(folder.path())) {
        // Whether a process's memory can be read in these ways depends on the user and the machine.
        if (attempt.attempt == "read memory" || attempt.about.ends_with("/mem")) continue;
        CAPTURE(attempt.attempt, attempt.about);
        const ConfinedRun run =
            run_attempt(confinement(Profile::worker, Tier::c), attempt.attempt, attempt.about);
        CAPTURE(run.output);
        const bool starts_hello = attempt.attempt.starts_with("execute");
        const bool is_memory = attempt.attempt == "executable memory";
        const std::string expected = starts_hello && !is_memory ? "hello\n" : "done\n";
        REQUIRE(run.output.find(expected) != std::string::npos);
    }
}

TEST_CASE("sandbox: calls by another interface of the kernel are blocked")
{
    for (const Tier tier : walled_tiers())
        for (const std::string interface : {"old interface", "second interface"}) {
            CAPTURE(description(tier), interface);
            const ConfinedRun run = run_attempt(confinement(Profile::worker, tier), interface);
            CAPTURE(run.output);
            REQUIRE((run.signal == SIGSYS || run.blocked_call));
            REQUIRE(run.output.empty());
        }
}

TEST_CASE("sandbox: the filter is in force before the first constructor")
{
    for (const Tier tier : walled_tiers()) {
        CAPTURE(description(tier));
        const ConfinedRun run = run_confined(confinement(Profile::worker, tier),
                                             {program("attempt_in_constructor")}, ample_time());
        REQUIRE(
            (run.blocked_call ? blocked(run) == "open a network socket" : run.signal == SIGSYS));
        REQUIRE(run.output.empty());
    }
}

TEST_CASE("sandbox: what programs try and can do without fails quietly")
{
    for (const Tier tier : walled_tiers()) {
        CAPTURE(description(tier));
        const Confinement walls = confinement(Profile::worker, tier);
        REQUIRE(run_attempt(walls, "look", "/etc/passwd").output.starts_with("failed: "));
        REQUIRE(run_attempt(walls, "raise a limit").output.starts_with("failed: "));
    }
}

TEST_CASE("sandbox: an honest worker computes as it does without walls")
{
    std::string printed;
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        const ConfinedRun run =
            run_confined(confinement(Profile::worker, tier), {program("compute")}, ample_time());
        CAPTURE(blocked(run), run.output, run.status, run.signal);
        REQUIRE(run.ok());
        REQUIRE(run.output.ends_with("the end\n"));
        REQUIRE(run.output.find(" 0\n") == std::string::npos);
        if (printed.empty()) printed = run.output;
        REQUIRE(run.output == printed);
    }
}

TEST_CASE("sandbox: the end of a program is told as it was")
{
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        const Confinement walls = confinement(Profile::worker, tier);
        REQUIRE(run_attempt(walls, "exit").status == 3);
        REQUIRE(run_attempt(walls, "abort").signal == SIGABRT);
        REQUIRE(run_attempt(walls, "crash").signal == SIGSEGV);
        RunLimits limits;
        limits.time = std::chrono::milliseconds(200);
        limits.output = 100000;
        REQUIRE(run_confined(walls, {program("attempt"), "loop"}, limits).timed_out);
        limits.time = ample_time().time;
        REQUIRE(run_confined(walls, {program("attempt"), "stop"}, limits).stopped);
        const ConfinedRun flood = run_confined(walls, {program("attempt"), "flood"}, limits);
        REQUIRE(flood.flooded);
        REQUIRE(flood.output.starts_with("a line that is repeated without end\n"));
        REQUIRE(flood.output.size() <= limits.output_kept);
    }
}

namespace {

// Whether a process ends within a few seconds. One that has ended may have no parent that asks how.
bool ends_soon(pid_t process)
{
    for (int i = 0; i < 300; ++i) {
        std::ifstream file("/proc/" + std::to_string(process) + "/stat");
        std::string text;
        if (!std::getline(file, text) || text[text.rfind(") ") + 2] == 'Z') return true;
        usleep(10000);
    }
    return false;
}

} // namespace

TEST_CASE("sandbox: a program that has stopped itself ends with its grader")
{
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        int ends[2];
        REQUIRE(pipe(ends) == 0);
        const pid_t grader = fork();
        if (grader == 0) {
            const Confined stopped(confinement(Profile::worker, tier), {program("attempt"), "stop"},
                                   {});
            siginfo_t info;
            waitid(P_PID, stopped.monitor(), &info, WSTOPPED | WNOWAIT);
            const pid_t monitor = stopped.monitor();
            if (write(ends[1], &monitor, sizeof monitor) == sizeof monitor) pause();
            _exit(1);
        }
        close(ends[1]);
        pid_t monitor = 0;
        REQUIRE(read(ends[0], &monitor, sizeof monitor) == sizeof monitor);
        close(ends[0]);
        kill(grader, SIGKILL);
        waitpid(grader, nullptr, 0);
        REQUIRE(ends_soon(monitor));
    }
}

TEST_CASE("sandbox: limits on resources hold in every tier")
{
    const TemporaryFolder folder;
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        const Confinement walls = confinement(Profile::worker, tier);
        const ConfinedRun huge = run_confined(walls, {program("huge_statics")}, ample_time());
        REQUIRE(huge.signal == SIGSEGV); // the kernel ends a program that does not fit
        REQUIRE(huge.output.empty());
    }
    Confinement short_of_time = confinement(Profile::worker, usual_tier());
    short_of_time.limits.processor_time = 1;
    const ConfinedRun loop =
        run_confined(short_of_time, {program("attempt"), "loop"}, ample_time());
    REQUIRE((loop.signal == SIGKILL || loop.signal == SIGXCPU));
    // For the limit, the kernel counts whole ticks of its clock; the time that it reports here is
    // measured. So the two differ.
    REQUIRE(loop.processor_seconds > 0.3);
    REQUIRE(loop.processor_seconds < 3);

    Confinement walls = confinement(Profile::worker, Tier::c);
    walls.limits.file_size = 1 << 20;
    const std::filesystem::path file = folder.path() / "large";
    REQUIRE(run_attempt(walls, "fill the disk", file).output == "failed: File too large\n");
    REQUIRE(std::filesystem::file_size(file) == 1 << 20);
}

} // namespace rigor
