// SPDX-License-Identifier: MIT
#include "report/exports/csv.hpp"

#include <fmt/format.h>

namespace rigor {

namespace {

bool is_number(const std::string& cell)
{
    return cell.find_first_not_of("0123456789.") == std::string::npos;
}

// Spreadsheets run a cell that begins with one of these, also after spaces.
bool looks_like_formula(const std::string& cell)
{
    const std::size_t first = cell.find_first_not_of(' ');
    return first != std::string::npos &&
           std::string_view("=+-@\t\r\n").find(cell[first]) != std::string_view::npos;
}

std::string quoted(const std::string& cell)
{
    if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
    std::string text = "\"";
    for (const char c : cell)
        text += c == '"' ? std::string("\"\"") : std::string(1, c);
    return text + "\"";
}

} // namespace

std::string csv_line(const std::vector<std::string>& cells)
{
    std::string line;
    for (const std::string& cell : cells) {
        if (&cell != cells.data()) line += ',';
        const bool guarded = !is_number(cell) && looks_like_formula(cell);
        line += quoted((guarded ? "'" : "") + cell);
    }
    return line + "\r\n";
}

std::string csv_number(double points)
{
    return fmt::format("{}", points == 0 ? 0.0 : points);
}

} // namespace rigor
