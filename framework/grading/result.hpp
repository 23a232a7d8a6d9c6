// SPDX-License-Identifier: MIT
// The result of grading: the content of result.json.
#pragma once

#include "grading/assignment.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// The outcome of a test case or a task, from the best to the worst. The outcome of a task is the
/// worst of its test cases.
///
/// A crash is worse than a wrong value, since it hides failures that later checks would find.
/// `failed` is worse than `not_implemented`: a task with a wrong answer of its own has failed, even
/// if another of its cases ends in a stub.
enum class Status {
    passed,
    skipped,
    not_implemented,
    compile_error, // the formula, or one that it calls, did not compile or is missing
    failed,
    not_finite,
    timed_out,
    crashed
};

std::string_view to_string(Status status);
/// The status with this name; empty if there is none.
std::optional<Status> status_of(std::string_view text);

/// A test case's verdict, as the test program sent it.
struct TestCase {
    std::string name; // such as "inertia: the union of two hemispheres is a sphere"
    Status status = Status::passed;
    std::string message, hint; // in the words of the test program
    std::string mistake; // why the answers are wrong, in one sentence; empty if it is not known
    /// What a comparison of numbers found, as text; empty if the test case compared no numbers.
    std::string expected, actual, error, tolerance, tolerance_class;
    std::string place;                // the part of the result that is wrong, such as a field
    std::optional<std::int64_t> seed; // seed of the failed case
    bool is_hidden = false;
    double largest_error = 0; // largest error / tolerance of the comparisons that passed
    double seconds = 0;
};

struct TaskResult {
    Task task;
    Status status = Status::skipped;
    double score = 0, max_score = 0; // both 0 if this run cannot judge the task
    std::vector<TestCase> tests;
    /// Whether the points were earned with the reference in place of the formulas that the task
    /// builds on. So an error in one formula costs the points of one task only.
    bool follow_through = false;

    /// The test case of this law; nullptr if it did not run.
    const TestCase* of_law(std::string_view law) const;
    /// The first test case with the worst outcome, if possible one without a seed; nullptr if all
    /// passed.
    const TestCase* first_failure() const;
    /// Why the answers are wrong: the first `mistake` of a test case that is not empty; empty if
    /// there is none.
    std::string mistake() const;
};

enum class SubmissionStatus { graded, compile_error, rejected, internal_error };
std::string_view to_string(SubmissionStatus status);

struct Result {
    Assignment assignment;
    std::string submission; // "student", "reference", a folder, or a name in a class
    SubmissionStatus status = SubmissionStatus::graded;
    std::string message; // explains a status other than `graded`
    std::uint32_t seed = 0;
    bool has_secret_seeds = false; // whether the seeds come from a secret of the course
    std::vector<TaskResult> tasks;
    double build_seconds = 0, test_seconds = 0;
    std::string walls; // the sandbox around the submission: "A: namespaces, uid, seccomp, Landlock"
    std::vector<std::string> notes; // further remarks for the reader, such as ignored files
    /// Hash of all that the result depends on. If it is empty, the next run grades the submission
    /// again.
    std::string fingerprint;

    double score() const;
    double max_score() const;
    bool all_points() const { return status == SubmissionStatus::graded && score() == max_score(); }
};

/// The result of a submission of which no test ran. Each counted task has 0 of its points, and each
/// other task 0 of 0.
/// @param tags     the tasks that are listed
/// @param counted  the tasks that could have been judged
Result ungraded(const Assignment& assignment, const std::vector<std::string>& tags,
                const std::vector<std::string>& counted, SubmissionStatus status,
                const std::string& message);

/// The result of a task from its test cases. If there are none, or if the worst outcome is
/// `skipped`, the task has 0 of 0 points. Otherwise it gets all of its points if each test case
/// passed, or else the points of each part whose law held.
TaskResult score_task(const Task& task, std::vector<TestCase> tests);

/// Removes from the result what its task does not disclose. Nothing can be judged again afterwards.
void hide_undisclosed(TaskResult& result);

/// Whether a test case failed in a random case, whose seed it names.
bool failed_at_random(const TestCase& test);

/// If a test case failed in a random case, and the reference fails in this test case too, there is
/// a fault in the test. Counts each such test case as passed, and scores the task again if there is
/// one.
/// @param of_reference  the verdicts on the reference, with the same random cases
/// @return the names of these test cases
std::vector<std::string> forgive_faults_of_tests(const std::vector<TestCase>& of_reference,
                                                 TaskResult& task);

} // namespace rigor
