// SPDX-License-Identifier: MIT
#include "scene/language/values.hpp"

#include "errors/nearest.hpp"
#include "scene/language/keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// Numbers with a larger absolute value are refused, in whatever unit the key has: the limit guards
// products against overflow.
constexpr double largest = 1e12; // the error messages repeat this number

} // namespace

double number(const Value& value, std::string_view what)
{
    if (value.kind != Value::Kind::number) expected(what, value);
    if (!(std::abs(value.number) <= largest))
        expected(fmt::format("{} of at most 1e12 in size", what), value);
    return value.number;
}

double positive(const Value& value, std::string_view what)
{
    const std::string wanted = fmt::format("{} > 0", what);
    const double x = number(value, wanted);
    if (!(x > 0)) expected(wanted, value);
    if (x < smallest_number) expected(fmt::format("{} of at least 1e-12", what), value);
    return x;
}

double not_negative(const Value& value, std::string_view what)
{
    const std::string wanted = fmt::format("{} ≥ 0", what);
    const double x = number(value, wanted);
    if (!(x >= 0)) expected(wanted, value);
    return x;
}

double in_range(const Value& value, std::string_view what, double low, double high)
{
    const std::string wanted = fmt::format("{} from {} to {}", what, low, high);
    const double x = number(value, wanted);
    if (!(x >= low && x <= high)) expected(wanted, value);
    return x;
}

std::int64_t integer(const Value& value, std::string_view what, std::int64_t low, std::int64_t high)
{
    const std::string wanted = fmt::format("{}, a whole number from {} to {}", what, low, high);
    const double x = number(value, wanted);
    if (x != std::floor(x) || x < static_cast<double>(low) || x > static_cast<double>(high))
        expected(wanted, value);
    return static_cast<std::int64_t>(x);
}

bool boolean(const Value& value)
{
    if (value.kind != Value::Kind::boolean) expected("true or false", value);
    return value.truth;
}

std::string line_of_text(const Value& value, std::string_view what)
{
    if (value.kind != Value::Kind::string || value.text.empty()) expected(what, value);
    for (const char c : value.text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            expected(fmt::format("{} without control characters", what), value);
    return value.text;
}

const std::vector<Value>& array(const Value& value, std::string_view what)
{
    if (value.kind != Value::Kind::array) expected(what, value);
    return value.items;
}

Vector3d vector3(const Value& value, std::string_view what)
{
    if (array(value, what).size() != 3) expected(what, value);
    Vector3d v;
    for (int i = 0; i < 3; ++i)
        v[i] = number(value.items[i]);
    return v;
}

Vector3d positive3(const Value& value, std::string_view what)
{
    const std::string wanted = fmt::format("three of {} > 0", what);
    if (array(value, wanted).size() != 3) expected(wanted, value);
    Vector3d v;
    for (int i = 0; i < 3; ++i)
        v[i] = positive(value.items[i], what);
    return v;
}

Vector3d scale3(const Value& value, std::string_view what)
{
    if (value.kind == Value::Kind::array) return positive3(value, what);
    return Vector3d::Constant(positive(value, what));
}

Vector3d color(const Value& value)
{
    if (array(value, "a color [red, green, blue]").size() != 3)
        expected("a color [red, green, blue]", value);
    Vector3d v;
    for (int i = 0; i < 3; ++i)
        v[i] = in_range(value.items[i], "a part of a color", 0, 1);
    return v;
}

std::size_t one_of(const Value& value, std::span<const std::string_view> words)
{
    if (value.kind == Value::Kind::string) {
        const auto word = std::find(words.begin(), words.end(), value.text);
        if (word != words.end()) return static_cast<std::size_t>(word - words.begin());
        throw Mistake{value.line, fmt::format("expected one of {}, found {}{}", list_of(words),
                                              describe(value), suggestion(value.text, words))};
    }
    expected(fmt::format("one of {}", list_of(words)), value);
}

} // namespace rigor
