// SPDX-License-Identifier: MIT
// The numbers that a handout shows, compared with those that the formulas give.
#pragma once

#include "formulas/types.hpp"

#include <string>
#include <vector>

namespace rigor::handouts {

/// A text with one blank for all space between words.
std::string in_one_line(const std::string& text);

/// Checks that a handout contains the quote, and that the numbers in it are these to their last
/// digit. An index and an exponent are no numbers.
void check_shown(const std::string& label, const std::string& quote,
                 const std::vector<double>& values);

std::vector<double> listed(const Vector3d& v);
std::vector<double> rows_of(const Matrix3d& A);

} // namespace rigor::handouts
