// SPDX-License-Identifier: MIT
#pragma once

#include "grading/result.hpp"

#include <functional>
#include <string>

namespace rigor {

/// Looks up an environment variable: returns its value, or an empty text if it is not set.
using Variable = std::function<std::string(const char* name)>;

/// The result.json that Classroom 50 expects of an autograder, in its format
/// `classroom50/result/v1`: whose submission this is, from the environment variables of the runner,
/// and the points of each task. The format has whole points only, so points are rounded down.
/// @param now  a time in UTC, as 2026-09-01T08:00:00Z; the runner replaces it by the time of the
///     commit
/// @return an empty text outside of the runner, or for an `internal_error`: the runner then reports
///     that the autograder failed
std::string classroom50_json(const Result& result, const Variable& variable,
                             const std::string& now);

} // namespace rigor
