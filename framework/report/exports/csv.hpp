// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A line of a CSV file (RFC 4180): cells with commas, quotes or line breaks are in quotes, and the
/// line ends with CR LF. A text that a spreadsheet would take for a formula gets an apostrophe in
/// front; a number never does.
std::string csv_line(const std::vector<std::string>& cells);

/// A number as a cell: the shortest decimal number that gives the same double when it is read.
std::string csv_number(double number);

} // namespace rigor
