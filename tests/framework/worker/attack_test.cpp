// SPDX-License-Identifier: MIT
// Tests of the hostile implementations in tests/attacks/*/*.cpp. Each gets the right verdict in
// bounded time, and the next call on a fresh worker is answered.
#include "attack.hpp"
#include "support/catch.hpp"

#include <sstream>

namespace rigor {

namespace {

struct Expected {
    std::string attack;
    WorkerFailure::Cause cause;
    std::string text; // a part of the message
};

const std::string subject = "A1.1 cross_matrix";

const Expected verdicts[] = {
    {"segmentation_fault", WorkerFailure::crashed,
     "crashed: segmentation fault, such as by an index outside of a list or endless recursion"},
    {"stack_overflow", WorkerFailure::crashed,
     "crashed: segmentation fault, such as by an index outside of a list or endless recursion"},
    {"abort", WorkerFailure::crashed, "crashed: aborted"},
    {"stop_itself", WorkerFailure::crashed, "stopped itself: signal SIGSTOP"},
    {"exit_zero", WorkerFailure::exited, "exit status 0"},
    {"exit_at_once", WorkerFailure::exited, "exit status 3"},
    {"endless_loop", WorkerFailure::timed_out, "did not return within 0.6 s"},
    {"sleep_in_destructor", WorkerFailure::timed_out, "did not return within 0.6 s"},
    {"flood_output", WorkerFailure::flooded, "printed more than 1024 kB"},
    {"throw_int", WorkerFailure::threw, "threw something that is no std::exception"},
    {"throw_exception", WorkerFailure::threw, "threw an exception: vector::at"},
    {"throw_without_text", WorkerFailure::threw, "threw an exception without a text"},
    {"scribble", WorkerFailure::malformed, "answered out of turn"},
    {"wrong_size", WorkerFailure::malformed, "sent 18446744073709551615 bytes"},
    {"unknown_kind", WorkerFailure::malformed, "an answer of no known kind"},
    {"truncated_reply", WorkerFailure::malformed, "it ends in the middle of a value"},
#ifndef RIGOR_SANITIZED // a sanitizer handles memory and threads in its own way
    {"exit_main_thread", WorkerFailure::exited, "exit status 0"},
    {"huge_vector", WorkerFailure::threw, "out of memory"},
    {"hoard_memory", WorkerFailure::threw, "out of memory"},
#endif
};

} // namespace

TEST_CASE("attack: each failure has its verdict and the run goes on")
{
    for (const Expected& expected : verdicts) {
        CAPTURE(expected.attack);
        use_worker(attack(expected.attack), {}, tight());
        for (int repeat = 0; repeat < 2; ++repeat) {
            const Clock::time_point start = Clock::now();
            try {
                attacked();
                FAIL("it was answered");
            } catch (const WorkerFailure& failure) {
                CAPTURE(failure.what());
                REQUIRE(failure.cause == expected.cause);
                REQUIRE(failure.subject == subject);
                REQUIRE(std::string(failure.what()).find(expected.text) != std::string::npos);
            }
            REQUIRE(Seconds(Clock::now() - start) < Seconds(3 * sanitizer_factor));
            REQUIRE(next_call_is_answered());
        }
    }
}

TEST_CASE("attack: a NaN is named by formula and place")
{
    use_worker(attack("nan"), {}, tight());
    REQUIRE_THROWS_WITH(attacked(), subject + ": its entry (0, 1) is NaN");
    REQUIRE(next_call_is_answered());
}

TEST_CASE("attack: a stub is no crash")
{
    use_worker(attack("not_implemented"), {}, tight());
    REQUIRE_THROWS_AS(attacked(), NotImplemented);
    REQUIRE_THROWS_WITH(attacked(), "kinematics::cross_matrix");
    REQUIRE(next_call_is_answered());
}

TEST_CASE("attack: an answer to a question not asked yet counts for none")
{
    use_worker(attack("early_reply"), {}, tight());
    try {
        attacked(); // this call may still get the early answer
        attacked();
        FAIL("both were answered");
    } catch (const WorkerFailure& failure) {
        REQUIRE(failure.cause == WorkerFailure::malformed);
    }
    REQUIRE(next_call_is_answered());
}

TEST_CASE("attack: a program that does not start says so and is not tried for ever")
{
    use_worker(attack("crash_in_initializer"), {}, tight());
    for (int repeat = 0; repeat < 3; ++repeat)
        REQUIRE_THROWS_WITH(next_call_is_answered(),
                            "the start of the program crashed: segmentation fault, such as by an "
                            "index outside of a list or endless recursion");

    Limits limits = tight();
    limits.start = Seconds(0.3);
    use_worker(attack("loop_in_initializer"), {}, limits);
    const Clock::time_point start = Clock::now();
    for (int repeat = 0; repeat < 50; ++repeat)
        REQUIRE_THROWS_AS(next_call_is_answered(), WorkerFailure);
    REQUIRE(Seconds(Clock::now() - start) < Seconds(3 * sanitizer_factor));
}

TEST_CASE("attack: a program that starts slowly each time is soon started no more")
{
    Limits limits = tight();
    limits.all_starts = Seconds(1);
    limits.late_start = Seconds(0.25);
    use_worker(attack("slow_start"), {}, limits);
    const Clock::time_point start = Clock::now();
    int answered = 0;
    std::string last_words;
    for (int repeat = 0; repeat < 50; ++repeat) {
        try {
            answered += next_call_is_answered() ? 1 : 0;
        } catch (const WorkerFailure& failure) {
            REQUIRE(failure.cause == WorkerFailure::timed_out);
            last_words = failure.what();
        }
        worker().renew();
    }
    REQUIRE(Seconds(Clock::now() - start) < Seconds(3 * sanitizer_factor));
    REQUIRE(answered > 0);
    REQUIRE(last_words.starts_with("the start of the program took longer than"));
    REQUIRE(last_words.find("(all starts together may take 1 s) before any function is called: "
                            "look at what it defines globally") != std::string::npos);
}

TEST_CASE("attack: what it printed before its end is kept and only the beginning")
{
    use_worker(attack("segmentation_fault"), {}, tight());
    try {
        attacked();
        FAIL("it was answered");
    } catch (const WorkerFailure& failure) {
        REQUIRE(failure.output == "about to crash\n");
    }
    use_worker(attack("flood_output"), {}, tight());
    try {
        attacked();
        FAIL("it was answered");
    } catch (const WorkerFailure& failure) {
        REQUIRE(failure.output.size() == 4096);
        REQUIRE(failure.output.substr(0, 15) == "I am still here");
    }
}

TEST_CASE("attack: a forged verdict is only text")
{
    use_worker(attack("forge_verdict"), {}, tight());
    REQUIRE(attacked() == Matrix3d::Zero());
    const std::string printed = worker().take_output();
    REQUIRE(printed.find("\"status\":\"passed\"") != std::string::npos);
    REQUIRE(worker().take_output().empty());
    REQUIRE(next_call_is_answered());
}

TEST_CASE("attack: closing every descriptor changes nothing")
{
    use_worker(attack("close_descriptors"), {}, tight());
    for (int repeat = 0; repeat < 3; ++repeat)
        REQUIRE(attacked() == 7 * Matrix3d::Identity());
    REQUIRE(next_call_is_answered());
}

TEST_CASE("attack: forked children neither answer nor outlive the worker")
{
    use_worker(attack("fork_children"), {}, tight());
    for (int repeat = 0; repeat < 3; ++repeat)
        REQUIRE(attacked() == 7 * Matrix3d::Identity());
    REQUIRE(next_call_is_answered());
    std::istringstream printed(worker().take_output());
    renew_worker();
    int pid = 0, children = 0;
    for (; printed >> pid; ++children) {
        CAPTURE(pid);
        REQUIRE(dies_soon(pid));
    }
    REQUIRE(children == 24);
    REQUIRE(next_call_is_answered());
}

} // namespace rigor
