// SPDX-License-Identifier: MIT
#include "grading/class/isolated.hpp"

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <sched.h>
#include <stdexcept>
#include <unistd.h>

namespace rigor::testing {

namespace {

// What each piece of work returned, or its fault.
std::map<std::size_t, std::string> outcomes(std::size_t count, unsigned jobs,
                                            const std::function<std::string(std::size_t)>& work)
{
    std::map<std::size_t, std::string> result;
    run_isolated(count, {jobs}, work, [&](const WorkDone& done) {
        result[done.index] = done.text ? *done.text : "fault: " + done.fault;
    });
    return result;
}

} // namespace

TEST_CASE("isolated: every piece of work comes back whatever the number of jobs", "[class]")
{
    for (const unsigned jobs : {1u, 3u}) {
        const auto all = outcomes(10, jobs, [](std::size_t i) { return fmt::format("{}", i * i); });
        REQUIRE(all.size() == 10);
        for (const auto& [i, text] : all)
            REQUIRE(text == fmt::format("{}", i * i));
    }
}

TEST_CASE("isolated: a crash costs only what crashed", "[class]")
{
    const auto all = outcomes(4, 2, [](std::size_t i) -> std::string {
        if (i == 1) {
            std::fputs("about to fall\n", stderr);
            std::signal(SIGSEGV, SIG_DFL); // the test program has a handler of its own
            std::raise(SIGSEGV);
        }
        if (i == 2) throw std::runtime_error("cannot do this\x1b[31m");
        return "done";
    });
    REQUIRE(all == std::map<std::size_t, std::string>{
                       {0, "done"},
                       {1, "fault: it was ended by signal 11; its last words: about to fall"},
                       {2, "fault: cannot do this?[31m"},
                       {3, "done"}});
}

TEST_CASE("isolated: what fails once is tried again", "[class]")
{
    // The processes share a file, which counts the tries.
    std::FILE* tries = std::tmpfile();
    const auto all = outcomes(1, 1, [&](std::size_t) -> std::string {
        std::fseek(tries, 0, SEEK_END);
        const long before = std::ftell(tries);
        std::fputc('x', tries);
        std::fflush(tries);
        if (before == 0) throw std::runtime_error("first try");
        return fmt::format("try {}", before + 1);
    });
    std::fclose(tries);
    REQUIRE(all.at(0) == "try 2");
}

TEST_CASE("isolated: what takes too long is ended once and the others go on", "[class]")
{
    std::map<std::size_t, WorkDone> all;
    const auto start = std::chrono::steady_clock::now();
    run_isolated(
        3, {2, false, std::chrono::milliseconds(500)},
        [](std::size_t i) -> std::string {
            while (i == 1)
                pause();
            return "done";
        },
        [&](const WorkDone& done) { all[done.index] = done; });
    REQUIRE(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
    REQUIRE(all.size() == 3);
    REQUIRE(all.at(0).text == "done");
    REQUIRE(all.at(2).text == "done");
    REQUIRE_FALSE(all.at(1).text);
    REQUIRE(all.at(1).fault == "it took more than 0.5 s");
    REQUIRE_FALSE(all.at(1).was_tried_twice);
}

TEST_CASE("isolated: a piece of work keeps to one processor and another one to another", "[class]")
{
    // The second piece of work ends only when the first one has said where it runs.
    const TemporaryFolder folder;
    const auto processors = [] {
        cpu_set_t allowed;
        sched_getaffinity(0, sizeof allowed, &allowed);
        std::string numbers;
        for (int i = 0; i < CPU_SETSIZE; ++i)
            if (CPU_ISSET(i, &allowed)) numbers += fmt::format("{} ", i);
        return numbers;
    };
    const std::string all = processors();
    std::map<std::size_t, std::string> where;
    run_isolated(
        2, {2, true},
        [&](std::size_t i) {
            std::ofstream(folder.path() / std::to_string(i)) << processors();
            while (!std::filesystem::exists(folder.path() / std::to_string(1 - i)))
                usleep(1000);
            return processors();
        },
        [&](const WorkDone& done) { where[done.index] = done.text.value(); });
    for (const auto& [i, numbers] : where)
        REQUIRE(std::count(numbers.begin(), numbers.end(), ' ') == 1);
    if (std::count(all.begin(), all.end(), ' ') > 1) REQUIRE(where.at(0) != where.at(1));
    REQUIRE(processors() == all); // the grader itself goes where it likes
}

TEST_CASE("isolated: its end is noticed even if SIGCHLD was ignored", "[class]")
{
    std::signal(SIGCHLD, SIG_IGN);
    std::string text;
    const Isolation how{1, false, std::chrono::seconds(20)};
    run_isolated(
        1, how, [](std::size_t) { return "done"; },
        [&](const WorkDone& done) { text = done.text.value_or(done.fault); });
    REQUIRE(text == "done");
}

TEST_CASE("isolated: a long result comes whole", "[class]")
{
    const std::string text(3 << 20, 'x');
    REQUIRE(outcomes(1, 1, [&](std::size_t) { return text; }).at(0) == text);
}

} // namespace rigor::testing
