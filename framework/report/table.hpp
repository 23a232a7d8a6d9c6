// SPDX-License-Identifier: MIT
// A result as a student reads it: the points, then what is wrong, then what to do next. 80 columns.
#pragma once

#include "grading/implementation.hpp"
#include "grading/result.hpp"

#include <string>
#include <vector>

namespace rigor {

/// Where a formula is written, "student/inertia.cpp:42"; without the line if the file does not say.
std::string place_of(const Implementation& implementation, const std::string& topic,
                     const std::string& formula);

/// One result: its table of points and its failures.
std::string points_table(const Result& result, const Implementation& implementation, bool color);

/// Several results, one line each, and their sum.
std::string summary(const std::vector<Result>& results, bool color);

} // namespace rigor
