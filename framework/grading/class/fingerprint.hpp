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

/// The fingerprint of a submission's result, 16 hexadecimal digits. An archive counts byte by byte.
std::string fingerprint_of(const Submission& submission, std::uint64_t all_but_the_submission);

} // namespace rigor
