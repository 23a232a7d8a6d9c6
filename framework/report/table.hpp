// SPDX-License-Identifier: MIT
// The report that a student reads, in 80 columns: the points, what is wrong, and what to do next.
#pragma once

#include "grading/build/implementation.hpp"
#include "grading/result.hpp"

#include <string>
#include <vector>

namespace rigor {

/// Where a formula is defined, "student/inertia.cpp:42"; without the line if it is not found.
std::string place_of(const Implementation& implementation, const std::string& topic,
                     const std::string& formula);

/// One result: its table of points, its failures and the next step.
std::string points_table(const Result& result, const Implementation& implementation, bool color);

/// Several results, one line each, and their sum.
std::string summary(const std::vector<Result>& results, bool color);

} // namespace rigor
