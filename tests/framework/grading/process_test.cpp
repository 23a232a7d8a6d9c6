// SPDX-License-Identifier: MIT
#include "grading/process.hpp"
#include "support/catch.hpp"

#include <csignal>

namespace rigor::testing {

namespace {

struct Heard {
    Ended ended;
    std::vector<std::string> output, messages;
};

Heard heard(const std::string& script, double silence = 0)
{
    Heard result;
    Command command;
    command.arguments = {"sh", "-c", script};
    command.silence = silence;
    command.environment = {"RIGOR_TEST=seen"};
    result.ended = run(
        command, [&](std::string_view line) { result.output.emplace_back(line); },
        [&](std::string_view line) { result.messages.emplace_back(line); });
    return result;
}

using Lines = std::vector<std::string>;

} // namespace

TEST_CASE("process: output and messages come apart and whole", "[process]")
{
    const Heard result =
        heard("echo a; echo m >&3; echo b >&2; printf c; echo $RIGOR_TEST >&3; exit 5");
    REQUIRE(result.output == Lines{"a", "b", "c"});
    REQUIRE(result.messages == Lines{"m", "seen"});
    REQUIRE(result.ended.status == 5);
    REQUIRE_FALSE(result.ended.ok());
}

TEST_CASE("process: a shared stderr is no part of the output", "[process]")
{
    Command command;
    command.arguments = {"sh", "-c", "echo '[]'; echo 'expected on the terminal' >&2"};
    command.shares_stderr = true;
    Lines output;
    REQUIRE(run(command, [&](std::string_view line) { output.emplace_back(line); }).ok());
    REQUIRE(output == Lines{"[]"});
}

TEST_CASE("process: a signal and a silence are told apart", "[process]")
{
    const Heard killed = heard("kill -9 $$");
    REQUIRE(killed.ended.signal == SIGKILL);
    REQUIRE_FALSE(killed.ended.timed_out);
    const Heard silent = heard("exec sleep 60", 0.2);
    REQUIRE(silent.ended.timed_out);
    REQUIRE(silent.ended.seconds < 10);
    const Heard stubborn = heard("trap '' TERM; while :; do sleep 0.1; done", 0.2);
    REQUIRE(stubborn.ended.timed_out);
    REQUIRE(stubborn.ended.signal == SIGKILL);
    REQUIRE(heard("for i in 1 2 3 4; do sleep 0.1; echo $i; done", 0.3).ended.ok());
}

TEST_CASE("process: a program that leaves a child behind does not hold us up", "[process]")
{
    const Heard result = heard("sleep 5 & echo done");
    REQUIRE(result.output == Lines{"done"});
    REQUIRE(result.ended.seconds < 4);
}

TEST_CASE("process: an endless line is handed over in pieces", "[process]")
{
    const Heard result = heard("head -c 3000000 /dev/zero | tr '\\0' x");
    std::size_t total = 0;
    for (const std::string& piece : result.output)
        total += piece.size();
    REQUIRE(total == 3000000);
    REQUIRE(result.output.size() >= 2);
}

TEST_CASE("process: its end is noticed even if SIGCHLD was ignored", "[process]")
{
    std::signal(SIGCHLD, SIG_IGN);
    const Heard result = heard("sh -c 'exit 3'; exit $?", 20);
    REQUIRE(result.ended.status == 3);
    REQUIRE_FALSE(result.ended.timed_out);
}

TEST_CASE("process: what cannot be started is an error", "[process]")
{
    Command command;
    command.arguments = {"/no/such/program"};
    REQUIRE_THROWS_AS(run(command, [](std::string_view) {}), std::runtime_error);
}

} // namespace rigor::testing
