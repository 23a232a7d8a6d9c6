// SPDX-License-Identifier: MIT
// The graded tests, run against one implementation.
#pragma once

#include "grading/build/implementation.hpp"
#include "grading/result.hpp"
#include "grading/selection.hpp"

#include <functional>
#include <optional>

namespace rigor {

/// Called once for each task, when its first test case begins. `tasks` is how many tasks the run
/// has.
using OnTask = std::function<void(int tasks_begun, int tasks, const std::string& tag)>;

struct GradingRun {
    std::filesystem::path test_program; // the program `graded_tests`
    /// The worker program that runs the reference. Without it no hidden test runs.
    std::optional<std::filesystem::path> oracle;
    std::uint32_t seed = 0; // the first seed of each test's random cases, if there is no secret
    /// The course's secret, from which each submission and each test gets seeds of its own. If it
    /// is empty, the seeds are the same for everybody, and a student can know the random cases.
    std::string secret;
    double silence = 300; // longest silence of the test program [s]; tests end far earlier
    OnTask on_task;
};

/// Runs the tests of the selected tasks against an implementation and scores them.
///
/// If the test program fails (it dies, hangs, runs no test of a task, checks nothing in a test
/// case, or sends a line that cannot be parsed), or if the reference fails in a test case, the
/// result is `internal_error`. Such a result has no points and no tests, and is no grade. If the
/// topic's file did not compile, the result is `compile_error`.
Result grade(const Selection& selection, const Implementation& implementation,
             const GradingRun& run);

/// The result of a submission of which no test ran: it has 0 of the points that this run could
/// give.
Result ungraded(const Selection& selection, const GradingRun& run, SubmissionStatus status,
                const std::string& message);

/// The graded tests of this tree, with the reference as the oracle if there is one and if the
/// sandbox keeps submissions away from the reference. The test program and the oracle are built if
/// they are out of date.
GradingRun own_grading_run(const OnBuildStep& on_step = {});

} // namespace rigor
