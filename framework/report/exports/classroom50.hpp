// SPDX-License-Identifier: MIT
#pragma once

#include "grading/result.hpp"

#include <functional>
#include <string>

namespace rigor {

/// The value of an environment variable; empty if it is not set.
using Variable = std::function<std::string(const char* name)>;

/// result.json of an autograder of Classroom 50, by its contract `classroom50/result/v1`: whose
/// submission this is, as the variables of its runner say, and the points of each task. The
/// contract wants whole points; parts of a point are left out.
/// @param now  a time in UTC, as 2026-09-01T08:00:00Z; the runner puts that of the commit there
/// @return nothing outside of its runner, or for an `internal_error`: the runner then reports that
///     the autograder failed
std::string classroom50_json(const Result& result, const Variable& variable,
                             const std::string& now);

} // namespace rigor
