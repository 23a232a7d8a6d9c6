// SPDX-License-Identifier: MIT
// Tests of the tables of system calls: each number is called behind walls, also those that no
// kernel has yet.
#include "framework/sandbox/confine.hpp"
#include "sandbox/main/calls.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <sys/syscall.h>

namespace rigor {

using namespace testing;

namespace {

/// What happens to a call with arguments that no call accepts, by the table of a worker.
confine::Verdict worker_verdict(int call)
{
    const std::vector<confine::Rule> rules = confine::worker_rules({2, 100, 100}, true);
    const auto rule = std::find_if(rules.begin(), rules.end(),
                                   [&](const confine::Rule& row) { return row.call == call; });
    if (rule == rules.end()) return confine::Verdict::refused;
    const bool always = rule->condition.kind == confine::Condition::always;
    return always ? rule->verdict : rule->otherwise;
}

/// Newer kernels let two calls pass every filter (uretprobe and uprobe on x86-64). They serve code
/// that a debugger has put into a program, and otherwise fail or kill the program.
bool passes_every_filter([[maybe_unused]] int call)
{
#if defined(__x86_64__)
    return call == 335 || call == 336;
#else
    return false;
#endif
}

Tier with_listener()
{
    return possible_walls().listener ? strongest(possible_walls()) : Tier::c;
}

} // namespace

TEST_CASE("sandbox: a worker has the calls of its table and no other")
{
    const Tier tier = with_listener();
    if (tier == Tier::c) {
        WARN("skipped: the grader cannot learn of calls on this machine");
        return;
    }
    const Confinement walls = confinement(Profile::worker, tier);
    int refused = 0;
    for (int call = 0; call < 600; ++call) {
        CAPTURE(call);
        const ConfinedRun run = run_attempt(walls, "call", std::to_string(call));
        CAPTURE(run.output, run.signal, run.status);
        if (passes_every_filter(call)) continue;
        if (worker_verdict(call) == confine::Verdict::refused) {
            REQUIRE(run.blocked_call == call);
            REQUIRE(run.output.empty());
            ++refused;
        } else {
            REQUIRE(!run.blocked_call);
        }
    }
    REQUIRE(refused > 500);
}

TEST_CASE("sandbox: each call that no compiler needs is refused")
{
    const Tier tier = with_listener();
    if (tier == Tier::c) {
        WARN("skipped: the grader cannot learn of calls on this machine");
        return;
    }
    Confinement walls = confinement(Profile::compiler, tier);
    walls.readable = {program("attempt")};
    for (const confine::Rule& rule : confine::compiler_rules()) {
        CAPTURE(rule.call);
        const ConfinedRun run = run_attempt(walls, "call", std::to_string(rule.call));
        CAPTURE(run.output);
        if (rule.verdict == confine::Verdict::missing)
            REQUIRE(run.output == "done\n");
        else
            REQUIRE(run.blocked_call == rule.call);
    }
}

TEST_CASE("sandbox: the words for calls are those of their purpose")
{
    REQUIRE(words_for_blocked_call(SYS_socket) == "open a network socket");
    REQUIRE(words_for_blocked_call(SYS_execveat) == "start another program");
    REQUIRE(words_for_blocked_call(SYS_clone3) == "start a thread or another process");
    REQUIRE(words_for_blocked_call(599) == "make system call 599, which is not allowed here");
}

} // namespace rigor
