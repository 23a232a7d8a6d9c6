// SPDX-License-Identifier: MIT
// The readers of plain values. Each throws a Mistake that says what was expected; `what` names the
// quantity. The absolute value of a number is at most 1e12, and a number that must be positive is
// at least 1e-12, so that a product of a few numbers neither overflows nor underflows.
#pragma once

#include "formulas/types.hpp"
#include "scene/language/json.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Where a number must be positive, numbers below this are refused, in whatever unit the key has:
/// the limit guards quotients against overflow.
constexpr double smallest_number = 1e-12;

double number(const Value& value, std::string_view what = "a number");
double positive(const Value& value, std::string_view what);
double not_negative(const Value& value, std::string_view what);
double in_range(const Value& value, std::string_view what, double low, double high);
std::int64_t integer(const Value& value, std::string_view what, std::int64_t low,
                     std::int64_t high);
bool boolean(const Value& value);
std::string line_of_text(const Value& value, std::string_view what);
Vector3d vector3(const Value& value, std::string_view what = "three numbers");
Vector3d positive3(const Value& value, std::string_view what);
/// Three numbers > 0, or one number > 0 that stands for all three.
Vector3d scale3(const Value& value, std::string_view what);
Vector3d color(const Value& value);
const std::vector<Value>& array(const Value& value, std::string_view what);

/// Reads a text that must be one of `words`. Returns the index of this word.
std::size_t one_of(const Value& value, std::span<const std::string_view> words);

/// Reads a word that stands for a value of an enumeration. `words` has the order of the
/// enumeration, and `last` is the last value: if there are more words than values, or fewer, the
/// call does not compile.
template <auto last, std::size_t count>
decltype(last) enumerator(const Value& value, const std::string_view (&words)[count])
{
    static_assert(count == static_cast<std::size_t>(last) + 1, "each value needs a word");
    return static_cast<decltype(last)>(one_of(value, words));
}

} // namespace rigor
