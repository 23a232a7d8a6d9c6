// SPDX-License-Identifier: MIT
// result.json: one for each submission. Every other format is made from it.
//
//     {assignment, submission, status, message, score, max_score, seed,
//      tests: [{tag, name, status, score, max_score, visibility, message, mistake, expected,
//               actual, error, tolerance, tolerance_class, seed, hint,
//               cases: [{name, status, message, seconds}]}],
//      timing: {build_seconds, test_seconds}, versions: {rigor, compiler},
//      notes: [...], fingerprint}
//
// An entry of `tests` is a task, described by its first failure. A task that did not run has 0
// points, and 0 as the most. `notes` and `fingerprint` are there only if they are not empty:
// `rigor grade` notes the files that it ignored, and knows by the fingerprint whether the result is
// still that of the submission.
#pragma once

#include "grading/result.hpp"

#include <string>
#include <vector>

namespace rigor {

/// The JSON text of the results: one result as an object, several as an array.
std::string to_json(const std::vector<Result>& results);

} // namespace rigor
