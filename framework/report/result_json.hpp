// SPDX-License-Identifier: MIT
// result.json: one for each submission. The files about a whole class are made from these.
//
//     {assignment, submission, status, message, score, max_score, seed, seeds,
//      tests: [{tag, name, status, score, max_score, follow_through, visibility, message,
//               detail, mistake, expected, actual, error, tolerance, tolerance_class, place,
//               seed, hint, cases: [{name, status, visibility, message, seconds}]}],
//      walls, timing: {build_seconds, test_seconds}, versions: {rigor, compiler},
//      notes: [...], fingerprint}
//
// An entry of `tests` is a task, described by its first failure. A task that this run cannot judge
// has `score` 0 and `max_score` 0. `notes` and `fingerprint` are there only if they are not empty.
// `notes` has, for example, the files that `rigor grade` ignored. The fingerprint shows a later run
// whether it has to grade the submission again.
#pragma once

#include "grading/result.hpp"

#include <string>
#include <vector>

namespace rigor {

/// The JSON text of the results: one result as an object, several as an array.
std::string to_json(const std::vector<Result>& results);

} // namespace rigor
