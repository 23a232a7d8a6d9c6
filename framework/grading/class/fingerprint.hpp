// SPDX-License-Identifier: MIT
// What a result depends on, as a hash. As long as it is the same, a submission is not graded again.
#pragma once

#include "grading/intake/found_submissions.hpp"
#include "grading/run_tests.hpp"
#include "grading/selection.hpp"

#include <cstdint>
#include <string>

namespace rigor {

/// A hash of all but the submission: the assignment, this program, the tests, the reference and
/// what else is linked into a worker, the files of student/ that fill gaps, the scenes, the seed
/// and the walls.
std::uint64_t fingerprint_of(const Selection& selection, const GradingRun& run);

/// The fingerprint of a submission's result: two hashes of 16 hexadecimal digits, first that of all
/// but the submission, then that of both. An archive counts byte by byte.
std::string fingerprint_of(const Submission& submission, std::uint64_t all_but_the_submission);

/// Whether a result with this fingerprint depends on the same but for the submission.
bool is_of_the_same_tests(const std::string& fingerprint, std::uint64_t all_but_the_submission);

} // namespace rigor
