// SPDX-License-Identifier: MIT
// The graded tests, run against one implementation.
#pragma once

#include "grading/implementation.hpp"
#include "grading/result.hpp"
#include "grading/selection.hpp"

#include <functional>
#include <optional>

namespace rigor {

/// Called when a task's test case begins.
using OnTask = std::function<void(int tasks_begun, int tasks, const std::string& tag)>;

struct GradingRun {
    std::filesystem::path test_program; // graded_tests
    std::optional<std::filesystem::path>
        oracle; // the reference's worker: without it no hidden test runs
    std::uint32_t seed = 0;
    double silence = 300; // longest time for a test case [s]; the tests' own limits are far below
    OnTask on_task;
};

/// Runs the tests of the selected tasks against an implementation and scores them.
///
/// A fault of the test program (it dies, matches no test, checks nothing, says what cannot be
/// understood) makes the result `internal_error`: never a zero, and never a pass. An implementation
/// that did not compile is `compile_error`.
Result grade(const Selection& selection, const Implementation& implementation,
             const GradingRun& run);

/// The graded tests of this tree, with the reference as the oracle where there is one, both built
/// if they are stale.
GradingRun own_grading_run(const OnBuildStep& on_step = {});

} // namespace rigor
