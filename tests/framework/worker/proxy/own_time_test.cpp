// SPDX-License-Identifier: MIT
// A test program whose engine computes without end, because of the answers of a submission, ends
// itself or reports a failure of the submission.
#include "support/catch.hpp"
#include "worker/failure.hpp"
#include "worker/process.hpp"
#include "worker/proxy/own_time.hpp"

#include <ctime>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

namespace {

double on_processor()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void compute_for(double seconds)
{
    for (const double end = on_processor() + seconds; on_processor() < end;) {
    }
}

struct Child {
    std::string said;
    int status = 0;
};

// Runs `work` in a process of its own whose computing time is watched.
// @param stall  longest computing time between two calls of formulas [s]
template <class Work> Child watched(double stall, const Work& work)
{
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        close(ends[0]);
        watch_own_time({ends[1], "after ", " it stopped\n"}, stall);
        work();
        _exit(0);
    }
    close(ends[1]);
    Child ended;
    char letters[256];
    for (ssize_t n; (n = read(ends[0], letters, sizeof letters)) > 0;)
        ended.said.append(letters, static_cast<std::size_t>(n));
    close(ends[0]);
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(WIFEXITED(status));
    ended.status = WEXITSTATUS(status);
    return ended;
}

} // namespace

TEST_CASE("own time: a program that computes without end says so and ends itself", "[worker]")
{
    const Child ended = watched(0.5, [] {
        note_formula(FormulaIndex::split_element);
        compute_for(60 * sanitizer_factor);
    });
    CHECK(ended.status == stalled_status);
    CHECK(ended.said == "after split_element it stopped\n");
    CHECK(watched(0.5, [] { compute_for(60 * sanitizer_factor); }).said == "after  it stopped\n");
}

TEST_CASE("own time: calls of formulas show that a program goes on", "[worker]")
{
    const Child ended = watched(1, [] {
        for (int i = 0; i < 20; ++i) {
            note_formula(FormulaIndex::split_element);
            compute_for(0.1);
        }
    });
    CHECK(ended.status == 0);
    CHECK(ended.said.empty());
}

TEST_CASE("own time: calls without end are a failure of the submission", "[worker]")
{
    const Child ended = watched(60, [] {
        const OwnTimeLimit whole("the test", 60), part("scene bounce", 1);
        try {
            for (;;) {
                note_formula(FormulaIndex::split_element);
                compute_for(0.01);
            }
        } catch (const WorkerFailure& failure) {
            const bool is_told = std::string(failure.what()).starts_with("scene bounce does not");
            _exit(failure.cause == WorkerFailure::timed_out && is_told ? 17 : 18);
        }
    });
    CHECK(ended.status == 17);
}

TEST_CASE("own time: an outer limit holds inside an inner one", "[worker]")
{
    const OwnTimeLimit outer("the test", 0.05);
    const OwnTimeLimit inner("scene bounce", 60);
    inner.check();
    compute_for(0.1);
    REQUIRE_THROWS_AS(inner.check(), WorkerFailure);
}

} // namespace rigor
