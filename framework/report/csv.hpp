// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// A line of a CSV file (RFC 4180): cells with quotes, line breaks, or signs at which spreadsheets
/// in some country split a line, are in quotes, and the line ends with CR LF. A text that a
/// spreadsheet would take for a formula gets an apostrophe in front, also where the text begins
/// only after such a sign, as in `zoe;=1+1`. A number never gets one.
std::string csv_line(const std::vector<std::string>& cells);

/// A number as a cell: the shortest decimal number that gives the same double when it is read.
std::string csv_number(double number);

} // namespace rigor
