// SPDX-License-Identifier: MIT
#include "report/exports/csv.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace rigor {

namespace {

// Whether the whole cell is a finite number, which a spreadsheet never reads as a formula.
bool is_number(const std::string& cell)
{
    double number = 0;
    const char* const end = cell.data() + cell.size();
    const auto [stop, error] = std::from_chars(cell.data(), end, number);
    return error == std::errc() && stop == end && std::isfinite(number);
}

// A spreadsheet reads a cell as a formula if it begins with one of these signs, even after spaces.
// The last four are the full-width forms of =, +, - and @, which some spreadsheets read in this
// way.
constexpr std::string_view signs[] = {"=",      "+",      "-",      "@",
                                      "\t",     "\r",     "\n", // ASCII signs
                                      "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};

// Invisible characters: spaces, spaces that do not break, wide spaces, and the byte-order mark.
constexpr std::string_view spaces[] = {" ",      "\u00A0", "\u2002", "\u2003", "\u2007",
                                       "\u2009", "\u200B", "\u202F", "\u3000", "\uFEFF"};

template <std::size_t n>
std::size_t length_of_start(std::string_view text, const std::string_view (&starts)[n])
{
    for (const std::string_view start : starts)
        if (text.starts_with(start)) return start.size();
    return 0;
}

bool looks_like_formula(std::string_view cell)
{
    while (const std::size_t length = length_of_start(cell, spaces))
        cell.remove_prefix(length);
    return length_of_start(cell, signs) > 0;
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

std::string csv_number(double number)
{
    return fmt::format("{}", number == 0 ? 0.0 : number);
}

} // namespace rigor
