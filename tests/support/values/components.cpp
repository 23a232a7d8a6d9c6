// SPDX-License-Identifier: MIT
#include "support/values/components.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor::testing {

std::string Place::text() const
{
    if (!outer) return "";
    const std::string before = outer->text();
    if (field.empty()) return fmt::format("{}[{}]", before, index);
    return before + (before.empty() ? "" : ".") + std::string(field);
}

double Components::scale(std::size_t i) const
{
    const auto block = std::partition_point(blocks_.begin(), blocks_.end(),
                                            [i](const Block& one) { return one.end <= i; });
    if (block == blocks_.end() || i < block->first) return std::abs(numbers[i]);
    if (!block->norm) {
        block->norm = 0;
        for (std::size_t k = block->first; k < block->end; ++k)
            block->norm = std::hypot(*block->norm, numbers[k]);
    }
    return *block->norm;
}

void Components::block(const Place&, const NumberBlock& block)
{
    const std::size_t first = numbers.size();
    numbers.insert(numbers.end(), block.data, block.data + block.size());
    if (block.size() > 1) blocks_.push_back({first, numbers.size()});
}

void Components::size(std::size_t n)
{
    shape += std::to_string(n) + " elements ";
}

void Components::presence(bool is_present)
{
    shape += is_present ? "a value " : "empty ";
}

void ComponentName::block(const Place& place, const NumberBlock& block)
{
    const std::size_t n = static_cast<std::size_t>(block.size());
    if (left < n) {
        name = place.text();
        if (block.columns > 1)
            name += fmt::format("({}, {})", left % static_cast<std::size_t>(block.rows),
                                left / static_cast<std::size_t>(block.rows));
        else if (block.rows > 1)
            name += fmt::format("({})", left);
    }
    left -= n; // after the number is found, this is larger than any size
}

void ComponentText::block(const Place& place, const NumberBlock& block)
{
    constexpr std::size_t longest = 600; // [bytes]; more would fill the report
    if (text.size() >= longest) return;
    if (place.outer) text += (text.empty() ? "" : "  ") + place.text() + " ";
    if (block.size() > 1) text += "(";
    for (int row = 0; row < block.rows; ++row)
        for (int column = 0; column < block.columns; ++column) {
            if (column > 0) text += " ";
            if (column == 0 && row > 0) text += block.columns > 1 ? "; " : ", ";
            text += fmt::format("{:.6g}", block.data[row + block.rows * column]);
        }
    if (block.size() > 1) text += ")";
    if (text.size() >= longest) text += " …";
}

void ComponentText::presence(bool is_present)
{
    if (!is_present) text += "empty";
}

} // namespace rigor::testing
