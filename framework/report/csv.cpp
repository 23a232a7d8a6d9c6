// SPDX-License-Identifier: MIT
#include "report/csv.hpp"

#include "errors/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
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

// A spreadsheet reads a cell as a formula if it begins with one of these signs, even after spaces
// and invisible characters. The last four are the full-width forms of =, +, - and @, which some
// spreadsheets read in this way.
constexpr std::string_view formula_signs[] = {"=",      "+",      "-",      "@",
                                              "\uFF1D", "\uFF0B", "\uFF0D", "\uFF20"};

// Where spreadsheets split a line. In many countries they do so at semicolons, and then a quote in
// the middle of a cell does not keep them from it.
constexpr std::string_view cell_ends = ",;\t|\r\n";

bool looks_like_formula(std::string_view text)
{
    while (!text.empty()) {
        for (const std::string_view sign : formula_signs)
            if (text.starts_with(sign)) return true;
        std::size_t skipped = blank_size(text);
        // After a split, a quote may be the one that begins the cell.
        if (text[0] == '"' || character_size(text) == 0) skipped = 1;
        if (skipped == 0) return false;
        text.remove_prefix(skipped);
    }
    return false;
}

// The text with an apostrophe before each part that is a formula if the part is a cell.
std::string guarded(const std::string& cell)
{
    if (is_number(cell)) return cell;
    std::string text;
    for (std::size_t begin = 0; begin <= cell.size();) {
        const std::size_t end = std::min(cell.find_first_of(cell_ends, begin), cell.size());
        const std::string part = cell.substr(begin, end - begin);
        text += (looks_like_formula(part) ? "'" : "") + part;
        if (end < cell.size()) text += cell[end];
        begin = end + 1;
    }
    return text;
}

std::string quoted(const std::string& cell)
{
    if (cell.find('"') == std::string::npos && cell.find_first_of(cell_ends) == std::string::npos)
        return cell;
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
        line += quoted(guarded(cell));
    }
    return line + "\r\n";
}

std::string csv_number(double number)
{
    return fmt::format("{}", number == 0 ? 0.0 : number);
}

} // namespace rigor
